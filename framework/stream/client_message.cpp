// SPDX-License-Identifier: Apache-2.0
#include "framework/stream/client_message.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/stream/message_json.hpp"
#include "framework/stream/opcode.hpp"

namespace trocar::stream {
namespace {

Subscribe subscribe_of(const MessageJson& json) {
  Subscribe subscribe;
  for (const MessageJson& one : list_of(json, "subscriptions")) {
    if (!one.is_object()) throw std::invalid_argument("\"subscriptions\" needs a list of objects");
    subscribe.subscriptions.push_back(
        {id_of(member(one, "id"), "id"), id_of(member(one, "channelId"), "channelId")});
  }
  return subscribe;
}

SetParameters set_of(const MessageJson& json) {
  return {.values = values_of(json), .id = optional_text(json, "id")};
}

Unsubscribe unsubscribe_of(const MessageJson& json) {
  Unsubscribe unsubscribe;
  for (const MessageJson& one : list_of(json, "subscriptionIds"))
    unsubscribe.ids.push_back(id_of(one, "subscriptionIds"));
  return unsubscribe;
}

ClientMessage message_of(const MessageJson& json) {
  const std::string op = text_of(member(json, "op"), "op");
  if (op == "subscribe") return subscribe_of(json);
  if (op == "unsubscribe") return unsubscribe_of(json);
  if (op == "getParameters")
    return GetParameters{.names = names_of(json, "parameterNames"),
                         .id = optional_text(json, "id")};
  if (op == "setParameters") return set_of(json);
  if (op == "subscribeParameterUpdates")
    return WatchParameters{.names = names_of(json, "parameterNames"), .on = true};
  if (op == "unsubscribeParameterUpdates")
    return WatchParameters{.names = names_of(json, "parameterNames"), .on = false};
  if (op == "subscribeConnectionGraph") return WatchGraph{true};
  if (op == "unsubscribeConnectionGraph") return WatchGraph{false};
  for (const char* known : {"advertise", "unadvertise", "fetchAsset"})
    if (op == known) return NotOffered{op};
  throw std::invalid_argument(fmt::format("\"op\" = \"{}\" is not known", op.substr(0, 60)));
}

}  // namespace

ClientMessage parse_client_text(std::string_view text) {
  return message_of(parsed_message(text));
}

ClientMessage parse_client_bytes(std::span<const std::byte> bytes) {
  const auto opcode = take<std::uint8_t>(bytes);
  if (opcode == static_cast<std::uint8_t>(ClientOpcode::data)) return NotOffered{"message data"};
  if (opcode != static_cast<std::uint8_t>(ClientOpcode::call))
    throw std::invalid_argument(fmt::format(
        "a binary message begins with {}: 2, a service call, is known", static_cast<int>(opcode)));
  CallService call;
  call.service = take<std::uint32_t>(bytes);
  call.call = take<std::uint32_t>(bytes);
  call.encoding = take_text(bytes, "a service call's encoding");
  call.payload = as_text(bytes);
  return call;
}

std::string subscribe_text(const Subscribe& subscribe) {
  MessageJson list = MessageJson::array();
  for (const Subscribe::One& one : subscribe.subscriptions)
    list.push_back({{"id", one.id}, {"channelId", one.channel}});
  return MessageJson{{"op", "subscribe"}, {"subscriptions", list}}.dump();
}

std::string unsubscribe_text(const Unsubscribe& unsubscribe) {
  return MessageJson{{"op", "unsubscribe"}, {"subscriptionIds", unsubscribe.ids}}.dump();
}

std::string get_parameters_text(const GetParameters& get) {
  return MessageJson{{"op", "getParameters"}, {"parameterNames", get.names}, {"id", get.id}}.dump();
}

std::string set_parameters_text(const SetParameters& set) {
  MessageJson list = MessageJson::array();
  for (const NamedValue& one : set.values)
    list.push_back({{"name", one.name}, {"value", value_json(one.value)}});
  return MessageJson{{"op", "setParameters"}, {"parameters", list}, {"id", set.id}}.dump();
}

std::string watch_parameters_text(const WatchParameters& watch) {
  return MessageJson{{"op", watch.on ? "subscribeParameterUpdates" : "unsubscribeParameterUpdates"},
                     {"parameterNames", watch.names}}
      .dump();
}

std::string watch_graph_text(const WatchGraph& watch) {
  return MessageJson{{"op", watch.on ? "subscribeConnectionGraph" : "unsubscribeConnectionGraph"}}
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
