// SPDX-License-Identifier: Apache-2.0
#include "framework/stream/server_message.hpp"

#include <cstring>
#include <nlohmann/json.hpp>

#include "framework/stream/message_json.hpp"
#include "framework/stream/opcode.hpp"

namespace trocar::stream {
namespace {

using Json = nlohmann::ordered_json;

/// Texts of scripts may hold anything; JSON is UTF-8.
std::string written(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

const char* type_of(const ParameterValue& value) {
  if (std::holds_alternative<double>(value)) return "float64";
  return std::holds_alternative<std::vector<double>>(value) ? "float64_array" : nullptr;
}

template <typename Number>
std::byte* put(std::byte* at, Number number) {
  std::memcpy(at, &number, sizeof number);
  return at + sizeof number;
}

}  // namespace

std::string server_info(std::string_view name, std::string_view session,
                        const std::map<std::string, std::string>& metadata) {
  return written({{"op", "serverInfo"},
                  {"name", name},
                  {"capabilities",
                   {"time", "parameters", "parametersSubscribe", "services", "connectionGraph"}},
                  {"supportedEncodings", {"json"}},
                  {"metadata", metadata},
                  {"sessionId", session}});
}

std::string advertise(const std::vector<Channel>& channels) {
  Json list = Json::array();
  for (const Channel& channel : channels)
    list.push_back({{"id", channel.id},
                    {"topic", channel.topic},
                    {"encoding", channel.encoding},
                    {"schemaName", channel.schema_name},
                    {"schema", channel.schema},
                    {"schemaEncoding", channel.schema_encoding}});
  return written({{"op", "advertise"}, {"channels", std::move(list)}});
}

std::string unadvertise(const std::vector<std::uint32_t>& ids) {
  return written({{"op", "unadvertise"}, {"channelIds", ids}});
}

std::string advertise_services(const std::vector<ServiceOffer>& services) {
  const auto side = [](const std::string& name, const std::string& schema) -> Json {
    return {{"encoding", "json"},
            {"schemaName", name},
            {"schemaEncoding", "jsonschema"},
            {"schema", schema}};
  };
  Json list = Json::array();
  for (const ServiceOffer& one : services)
    list.push_back({{"id", one.id},
                    {"name", one.name},
                    {"type", one.name},
                    {"request", side(one.name + "_request", one.request)},
                    {"response", side(one.name + "_response", one.response)}});
  return written({{"op", "advertiseServices"}, {"services", std::move(list)}});
}

std::string status(StatusLevel level, std::string_view text, std::string_view id) {
  Json json = {{"op", "status"}, {"level", static_cast<int>(level)}, {"message", text}};
  if (!id.empty()) json["id"] = id;
  return written(json);
}

std::string parameter_values(const std::vector<NamedValue>& values, std::string_view id) {
  Json list = Json::array();
  for (const NamedValue& one : values) {
    Json json = {{"name", one.name}};
    if (Json value = value_json(one.value); !value.is_null()) json["value"] = std::move(value);
    if (const char* type = type_of(one.value)) json["type"] = type;
    list.push_back(std::move(json));
  }
  Json json = {{"op", "parameterValues"}, {"parameters", std::move(list)}};
  if (!id.empty()) json["id"] = id;
  return written(json);
}

std::string connection_graph(const std::vector<Topic>& topics,
                             const std::vector<std::string>& removed) {
  Json published = Json::array(), subscribed = Json::array();
  for (const Topic& topic : topics) {
    published.push_back({{"name", topic.name}, {"publisherIds", topic.publishers}});
    if (!topic.subscribers.empty())
      subscribed.push_back({{"name", topic.name}, {"subscriberIds", topic.subscribers}});
  }
  return written({{"op", "connectionGraphUpdate"},
                  {"publishedTopics", std::move(published)},
                  {"subscribedTopics", std::move(subscribed)},
                  {"advertisedServices", Json::array()},
                  {"removedTopics", removed},
                  {"removedServices", Json::array()}});
}

std::string call_failure(std::uint32_t service, std::uint32_t call, std::string_view text) {
  return written(
      {{"op", "serviceCallFailure"}, {"serviceId", service}, {"callId", call}, {"message", text}});
}

void write_data_head(std::span<std::byte, data_head> into, std::uint64_t time_ns) {
  std::byte* at = put(into.data(), static_cast<std::uint8_t>(ServerOpcode::data));
  put(put(at, std::uint32_t{0}), time_ns);
}

void set_subscription(std::span<std::byte> message, std::uint32_t id) {
  put(message.data() + 1, id);
}

std::vector<std::byte> time_message(std::uint64_t time_ns) {
  std::vector<std::byte> bytes(9);
  put(put(bytes.data(), static_cast<std::uint8_t>(ServerOpcode::time)), time_ns);
  return bytes;
}

std::vector<std::byte> call_response(std::uint32_t service, std::uint32_t call,
                                     std::string_view json) {
  constexpr std::string_view encoding = "json";
  std::vector<std::byte> bytes(13 + encoding.size() + json.size());
  std::byte* at = put(bytes.data(), static_cast<std::uint8_t>(ServerOpcode::call_response));
  at = put(put(put(at, service), call), static_cast<std::uint32_t>(encoding.size()));
  std::memcpy(at, encoding.data(), encoding.size());
  if (!json.empty()) std::memcpy(at + encoding.size(), json.data(), json.size());
  return bytes;
}

}  // namespace trocar::stream
