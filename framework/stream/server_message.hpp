// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// @file
/// What a server of the Foxglove WebSocket protocol says (subprotocols "foxglove.sdk.v1" and
/// "foxglove.websocket.v1", which are alike). Texts are JSON; bytes are little-endian.
/// Source: the protocol's description in the npm package @foxglove/ws-protocol 0.8.0.

namespace trocar::stream {

inline constexpr const char* subprotocols[] = {"foxglove.sdk.v1", "foxglove.websocket.v1"};

struct Channel {
  std::uint32_t id = 0;
  std::string topic;
  std::string encoding;  // "cdr", "json"
  std::string schema_name;
  std::string schema;
  std::string schema_encoding;  // "ros2msg", "jsonschema"
};

struct ServiceOffer {
  std::uint32_t id = 0;
  std::string name;
  std::string request;   // JSON schema
  std::string response;  // JSON schema
};

/// A parameter's value; monostate where it has none.
using ParameterValue = std::variant<std::monostate, double, bool, std::string, std::vector<double>>;

struct NamedValue {
  std::string name;
  ParameterValue value;
};

enum class StatusLevel { info, warning, error };

/// An output and the components at its two ends.
struct Topic {
  std::string name;
  std::vector<std::string> publishers;
  std::vector<std::string> subscribers;
};

std::string server_info(std::string_view name, std::string_view session,
                        const std::map<std::string, std::string>& metadata);
std::string advertise(const std::vector<Channel>& channels);
std::string unadvertise(const std::vector<std::uint32_t>& ids);
std::string advertise_services(const std::vector<ServiceOffer>& services);
std::string status(StatusLevel level, std::string_view text, std::string_view id = {});
/// @param id of the request that it answers, or ""
std::string parameter_values(const std::vector<NamedValue>& values, std::string_view id);
std::string connection_graph(const std::vector<Topic>& topics,
                             const std::vector<std::string>& removed);
std::string call_failure(std::uint32_t service, std::uint32_t call, std::string_view text);

inline constexpr std::size_t data_head = 13;  // [B] before a message's own bytes

/// Opcode, subscription, time; the message's own bytes follow. 0 as subscription is to be replaced
/// by set_subscription(), so that one buffer serves all subscribers.
void write_data_head(std::span<std::byte, data_head> into, std::uint64_t time_ns);
void set_subscription(std::span<std::byte> message, std::uint32_t id);
std::vector<std::byte> time_message(std::uint64_t time_ns);
std::vector<std::byte> call_response(std::uint32_t service, std::uint32_t call,
                                     std::string_view json);

}  // namespace trocar::stream
