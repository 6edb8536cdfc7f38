// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "framework/connection.hpp"
#include "framework/realtime/latest_slot.hpp"
#include "framework/realtime/sample_queue.hpp"
#include "framework/tick.hpp"

namespace trocar {

/// One wire between two threads of the loop. The producer's thread sends a value at the end of its
/// tick, with its date and whether it is computed from sound values; the reader's thread takes what
/// has arrived at the beginning of its tick and keeps a copy, to which the input points.
///
/// In virtual time a value arrives at a tick whose time is strictly later than that of the tick
/// that sent it, so that the order of threads at one instant does not show.
class Crossing {
 public:
  /// Where the reader's copy and what is known of it stand in its thread's memory.
  struct Target {
    std::byte* value = nullptr;
    std::int64_t* tick = nullptr;
    bool* valid = nullptr;
  };

  /// @param source the value in the producer's memory; also the reader's first value
  Crossing(const Connection& connection, std::span<const std::byte> source, const Target& target,
           std::string text);
  Crossing(const Crossing&) = delete;
  Crossing& operator=(const Crossing&) = delete;

  const Connection& connection() const { return connection_; }
  const std::string& text() const { return text_; }  // "surface.value → wall.offset"

  // For the producer's thread.
  /// False when a queue is full, and the value is lost.
  bool send(const Tick& tick, bool sound) RT_SAFE;

  // For the reader's thread.
  void receive(const Tick& tick, bool simulated) RT_SAFE;
  const SampleInfo& info() const RT_SAFE { return info_; }
  /// Why the value must not be used, or null: it is stale, or was computed from unsound values. A
  /// first value that is still to come is neither.
  const char* lost() const RT_SAFE { return lost_; }

 private:
  struct Head {
    std::int64_t tick = -1;
    std::int64_t time_ns = 0;
    std::int64_t sound = 1;
  };
  bool take(std::int64_t before) RT_SAFE;

  Connection connection_;
  std::string text_;
  std::span<const std::byte> source_;
  Target target_;
  std::optional<LatestSlot> latest_;
  std::optional<SampleQueue> queue_;
  std::vector<std::byte> outgoing_;              // the producer's
  alignas(64) std::vector<std::byte> incoming_;  // the reader's, from here on
  Head head_{};
  SampleInfo info_{.valid = false, .fresh = false};
  const char* lost_ = nullptr;
};

}  // namespace trocar
