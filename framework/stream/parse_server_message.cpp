// SPDX-License-Identifier: Apache-2.0
#include "framework/stream/parse_server_message.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/stream/message_json.hpp"
#include "framework/stream/opcode.hpp"

namespace trocar::stream {
namespace {

ServerInfo server_info_of(const MessageJson& json) {
  ServerInfo info{.name = text_of(member(json, "name"), "name"),
                  .session = optional_text(json, "sessionId"),
                  .metadata = {}};
  if (const auto found = json.find("metadata"); found != json.end() && found->is_object())
    for (const auto& [key, value] : found->items()) info.metadata[key] = text_of(value, "metadata");
  return info;
}

Advertise advertise_of(const MessageJson& json) {
  Advertise message;
  for (const MessageJson& one : list_of(json, "channels")) {
    if (!one.is_object()) throw std::invalid_argument("\"channels\" needs a list of objects");
    message.channels.push_back({.id = id_of(member(one, "id"), "id"),
                                .topic = text_of(member(one, "topic"), "topic"),
                                .encoding = text_of(member(one, "encoding"), "encoding"),
                                .schema_name = text_of(member(one, "schemaName"), "schemaName"),
                                .schema = text_of(member(one, "schema"), "schema"),
                                .schema_encoding = optional_text(one, "schemaEncoding")});
  }
  return message;
}

Unadvertise unadvertise_of(const MessageJson& json) {
  Unadvertise message;
  for (const MessageJson& one : list_of(json, "channelIds"))
    message.ids.push_back(id_of(one, "channelIds"));
  return message;
}

AdvertiseServices services_of(const MessageJson& json) {
  AdvertiseServices message;
  for (const MessageJson& one : list_of(json, "services")) {
    if (!one.is_object()) throw std::invalid_argument("\"services\" needs a list of objects");
    message.services.push_back({.id = id_of(member(one, "id"), "id"),
                                .name = text_of(member(one, "name"), "name"),
                                .request = {},
                                .response = {}});
  }
  return message;
}

Status status_of(const MessageJson& json) {
  const MessageJson& level = member(json, "level");
  if (!level.is_number_integer()) throw std::invalid_argument("\"level\" needs a whole number");
  return {
      .level = static_cast<StatusLevel>(std::clamp<std::int64_t>(level.get<std::int64_t>(), 0, 2)),
      .text = text_of(member(json, "message"), "message"),
      .id = optional_text(json, "id")};
}

/// A parameter without a value is one that the server does not know.
ParameterValues parameters_of(const MessageJson& json) {
  ParameterValues message{.values = {}, .id = optional_text(json, "id")};
  for (const MessageJson& one : list_of(json, "parameters")) {
    if (!one.is_object()) throw std::invalid_argument("\"parameters\" needs a list of objects");
    const auto value = one.find("value");
    message.values.push_back({text_of(member(one, "name"), "name"),
                              value == one.end() ? ParameterValue{} : value_of(*value)});
  }
  return message;
}

CallFailure call_failure_of(const MessageJson& json) {
  return {.service = id_of(member(json, "serviceId"), "serviceId"),
          .call = id_of(member(json, "callId"), "callId"),
          .text = text_of(member(json, "message"), "message")};
}

}  // namespace

ServerText parse_server_text(std::string_view text) {
  const MessageJson json = parsed_message(text);
  const std::string op = text_of(member(json, "op"), "op");
  if (op == "serverInfo") return server_info_of(json);
  if (op == "advertise") return advertise_of(json);
  if (op == "unadvertise") return unadvertise_of(json);
  if (op == "advertiseServices") return services_of(json);
  if (op == "status") return status_of(json);
  if (op == "parameterValues") return parameters_of(json);
  if (op == "serviceCallFailure") return call_failure_of(json);
  return Unasked{op.substr(0, 60)};
}

ServerBytes parse_server_bytes(std::span<const std::byte> bytes) {
  const auto opcode = take<std::uint8_t>(bytes);
  if (opcode == static_cast<std::uint8_t>(ServerOpcode::data)) {
    Data data;
    data.subscription = take<std::uint32_t>(bytes);
    data.time_ns = take<std::uint64_t>(bytes);
    data.bytes = bytes;
    return data;
  }
  if (opcode == static_cast<std::uint8_t>(ServerOpcode::call_response)) {
    CallResponse response;
    response.service = take<std::uint32_t>(bytes);
    response.call = take<std::uint32_t>(bytes);
    response.encoding = take_text(bytes, "a service call's encoding");
    response.payload = as_text(bytes);
    return response;
  }
  return Unasked{fmt::format("binary {}", static_cast<int>(opcode))};
}

}  // namespace trocar::stream
