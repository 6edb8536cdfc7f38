// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "framework/stream/server_message.hpp"

/// @file
/// What a client of the Foxglove WebSocket protocol says; see server_message.hpp.

namespace trocar::stream {

struct Subscribe {
  struct One {
    std::uint32_t id = 0;
    std::uint32_t channel = 0;
  };
  std::vector<One> subscriptions;
};
struct Unsubscribe {
  std::vector<std::uint32_t> ids;
};
struct GetParameters {
  std::vector<std::string> names;  // all when empty
  std::string id;
};
struct SetParameters {
  std::vector<NamedValue> values;
  std::string id;
};
struct WatchParameters {
  std::vector<std::string> names;  // all when empty
  bool on = true;
};
struct WatchGraph {
  bool on = true;
};
struct CallService {
  std::uint32_t service = 0;
  std::uint32_t call = 0;
  std::string encoding;
  std::string payload;
};
/// Something of the protocol that is not offered here: publishing, assets.
struct NotOffered {
  std::string op;
};

using ClientMessage = std::variant<Subscribe, Unsubscribe, GetParameters, SetParameters,
                                   WatchParameters, WatchGraph, CallService, NotOffered>;

/// Of bytes by anybody.
/// @throw std::invalid_argument with what is wrong
ClientMessage parse_client_text(std::string_view text);
ClientMessage parse_client_bytes(std::span<const std::byte> bytes);

/// The reverse, for clients.
std::string subscribe_text(const Subscribe& subscribe);
std::string unsubscribe_text(const Unsubscribe& unsubscribe);
std::string get_parameters_text(const GetParameters& get);
std::string set_parameters_text(const SetParameters& set);
std::string watch_parameters_text(const WatchParameters& watch);
std::string watch_graph_text(const WatchGraph& watch);
std::vector<std::byte> call_bytes(const CallService& call);

}  // namespace trocar::stream
