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

#include "framework/stream/server_message.hpp"

/// @file
/// What a server of the Foxglove WebSocket protocol says, read; the reverse of server_message.hpp.

namespace trocar::stream {

struct ServerInfo {
  std::string name;
  std::string session;
  std::map<std::string, std::string> metadata;
};
struct Advertise {
  std::vector<Channel> channels;
};
struct Unadvertise {
  std::vector<std::uint32_t> ids;
};
struct AdvertiseServices {
  std::vector<ServiceOffer> services;
};
struct Status {
  StatusLevel level = StatusLevel::info;
  std::string text;
  std::string id;
};
struct ParameterValues {
  std::vector<NamedValue> values;
  std::string id;
};
struct CallFailure {
  std::uint32_t service = 0;
  std::uint32_t call = 0;
  std::string text;
};
/// Something of the protocol that no client of ours asks for.
struct Unasked {
  std::string op;
};
struct CallResponse {
  std::uint32_t service = 0;
  std::uint32_t call = 0;
  std::string encoding;
  std::string payload;
};
/// A message of a channel: its bytes are those that were parsed.
struct Data {
  std::uint32_t subscription = 0;
  std::uint64_t time_ns = 0;
  std::span<const std::byte> bytes;
};

using ServerText = std::variant<ServerInfo, Advertise, Unadvertise, AdvertiseServices, Status,
                                ParameterValues, CallFailure, Unasked>;
using ServerBytes = std::variant<Data, CallResponse, Unasked>;

/// Of bytes by anybody.
/// @throw std::invalid_argument with what is wrong
ServerText parse_server_text(std::string_view text);
ServerBytes parse_server_bytes(std::span<const std::byte> bytes);

}  // namespace trocar::stream
