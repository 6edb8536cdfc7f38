// SPDX-License-Identifier: Apache-2.0
#include "framework/stream/client_message.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/stream/opcode.hpp"

namespace trocar::stream {
namespace {

using ClientJson = nlohmann::json;

[[noreturn]] void refuse_message(const std::string& what) {
  throw std::invalid_argument(what);
}

const ClientJson& member(const ClientJson& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) refuse_message(fmt::format("\"{}\" is missing", key));
  return *found;
}

const ClientJson& list_of(const ClientJson& object, const char* key) {
  const ClientJson& list = member(object, key);
  if (!list.is_array()) refuse_message(fmt::format("\"{}\" needs a list", key));
  return list;
}

std::uint32_t id_of(const ClientJson& json, const char* key) {
  if (!json.is_number_unsigned() ||
      json.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
    refuse_message(fmt::format("\"{}\" needs a whole number of 32 bits", key));
  return json.get<std::uint32_t>();
}

std::string text_of(const ClientJson& json, const char* key) {
  if (!json.is_string()) refuse_message(fmt::format("\"{}\" needs a text", key));
  return json.get<std::string>();
}

std::string optional_text(const ClientJson& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? "" : text_of(*found, key);
}

std::vector<std::string> names_of(const ClientJson& object) {
  std::vector<std::string> names;
  for (const ClientJson& one : list_of(object, "parameterNames"))
    names.push_back(text_of(one, "parameterNames"));
  return names;
}

ParameterValue value_of(const ClientJson& json) {
  if (json.is_number()) return json.get<double>();
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_string()) return json.get<std::string>();
  if (!json.is_array())
    refuse_message("\"value\" needs a number, a list of numbers, a text, true or false");
  std::vector<double> numbers;
  for (const ClientJson& one : json) {
    if (!one.is_number()) refuse_message("\"value\" is a list, but not of numbers");
    numbers.push_back(one.get<double>());
  }
  return numbers;
}

Subscribe subscribe_of(const ClientJson& json) {
  Subscribe subscribe;
  for (const ClientJson& one : list_of(json, "subscriptions")) {
    if (!one.is_object()) refuse_message("\"subscriptions\" needs a list of objects");
    subscribe.subscriptions.push_back(
        {id_of(member(one, "id"), "id"), id_of(member(one, "channelId"), "channelId")});
  }
  return subscribe;
}

SetParameters set_of(const ClientJson& json) {
  SetParameters set{.values = {}, .id = optional_text(json, "id")};
  for (const ClientJson& one : list_of(json, "parameters")) {
    if (!one.is_object()) refuse_message("\"parameters\" needs a list of objects");
    set.values.push_back({text_of(member(one, "name"), "name"), value_of(member(one, "value"))});
  }
  return set;
}

Unsubscribe unsubscribe_of(const ClientJson& json) {
  Unsubscribe unsubscribe;
  for (const ClientJson& one : list_of(json, "subscriptionIds"))
    unsubscribe.ids.push_back(id_of(one, "subscriptionIds"));
  return unsubscribe;
}

ClientMessage message_of(const ClientJson& json) {
  if (!json.is_object()) refuse_message("a message needs to be a JSON object");
  const std::string op = text_of(member(json, "op"), "op");
  if (op == "subscribe") return subscribe_of(json);
  if (op == "unsubscribe") return unsubscribe_of(json);
  if (op == "getParameters")
    return GetParameters{.names = names_of(json), .id = optional_text(json, "id")};
  if (op == "setParameters") return set_of(json);
  if (op == "subscribeParameterUpdates")
    return WatchParameters{.names = names_of(json), .on = true};
  if (op == "unsubscribeParameterUpdates")
    return WatchParameters{.names = names_of(json), .on = false};
  if (op == "subscribeConnectionGraph") return WatchGraph{true};
  if (op == "unsubscribeConnectionGraph") return WatchGraph{false};
  for (const char* known : {"advertise", "unadvertise", "fetchAsset"})
    if (op == known) return NotOffered{op};
  refuse_message(fmt::format("\"op\" = \"{}\" is not known", op.substr(0, 60)));
}

template <typename Number>
Number take(std::span<const std::byte>& bytes) {
  if (bytes.size() < sizeof(Number)) refuse_message("a binary message is too short");
  Number number;
  std::memcpy(&number, bytes.data(), sizeof number);
  bytes = bytes.subspan(sizeof number);
  return number;
}

std::string as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

ClientJson client_value(const ParameterValue& value) {
  return std::visit(
      [](const auto& one) -> ClientJson {
        if constexpr (std::is_same_v<std::decay_t<decltype(one)>, std::monostate>)
          return nullptr;
        else
          return one;
      },
      value);
}

}  // namespace

ClientMessage parse_client_text(std::string_view text) {
  const ClientJson json = ClientJson::parse(text, nullptr, false);
  if (json.is_discarded()) refuse_message("a message is not JSON");
  return message_of(json);
}

ClientMessage parse_client_bytes(std::span<const std::byte> bytes) {
  const auto opcode = take<std::uint8_t>(bytes);
  if (opcode == static_cast<std::uint8_t>(ClientOpcode::data)) return NotOffered{"message data"};
  if (opcode != static_cast<std::uint8_t>(ClientOpcode::call))
    refuse_message(fmt::format("a binary message begins with {}: 2, a service call, is known",
                               static_cast<int>(opcode)));
  CallService call;
  call.service = take<std::uint32_t>(bytes);
  call.call = take<std::uint32_t>(bytes);
  const auto length = take<std::uint32_t>(bytes);
  if (length > bytes.size())
    refuse_message("a service call is shorter than its encoding's name says");
  call.encoding = as_text(bytes.first(length));
  call.payload = as_text(bytes.subspan(length));
  return call;
}

std::string subscribe_text(const Subscribe& subscribe) {
  ClientJson list = ClientJson::array();
  for (const Subscribe::One& one : subscribe.subscriptions)
    list.push_back({{"id", one.id}, {"channelId", one.channel}});
  return ClientJson{{"op", "subscribe"}, {"subscriptions", list}}.dump();
}

std::string unsubscribe_text(const Unsubscribe& unsubscribe) {
  return ClientJson{{"op", "unsubscribe"}, {"subscriptionIds", unsubscribe.ids}}.dump();
}

std::string get_parameters_text(const GetParameters& get) {
  return ClientJson{{"op", "getParameters"}, {"parameterNames", get.names}, {"id", get.id}}.dump();
}

std::string set_parameters_text(const SetParameters& set) {
  ClientJson list = ClientJson::array();
  for (const NamedValue& one : set.values)
    list.push_back({{"name", one.name}, {"value", client_value(one.value)}});
  return ClientJson{{"op", "setParameters"}, {"parameters", list}, {"id", set.id}}.dump();
}

std::string watch_parameters_text(const WatchParameters& watch) {
  return ClientJson{{"op", watch.on ? "subscribeParameterUpdates" : "unsubscribeParameterUpdates"},
                    {"parameterNames", watch.names}}
      .dump();
}

std::string watch_graph_text(const WatchGraph& watch) {
  return ClientJson{{"op", watch.on ? "subscribeConnectionGraph" : "unsubscribeConnectionGraph"}}
      .dump();
}

std::vector<std::byte> call_bytes(const CallService& call) {
  std::vector<std::byte> bytes;
  const auto append = [&](const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
  };
  const auto opcode = static_cast<std::uint8_t>(ClientOpcode::call);
  const auto length = static_cast<std::uint32_t>(call.encoding.size());
  append(&opcode, sizeof opcode);
  append(&call.service, sizeof call.service);
  append(&call.call, sizeof call.call);
  append(&length, sizeof length);
  append(call.encoding.data(), call.encoding.size());
  append(call.payload.data(), call.payload.size());
  return bytes;
}

}  // namespace trocar::stream
