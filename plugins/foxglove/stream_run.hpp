// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "framework/realtime/broadcast_ring.hpp"
#include "framework/recording/row_layout.hpp"
#include "framework/stream/server_message.hpp"

namespace trocar::foxglove {

/// What lies in a run's ring, in the low bits of a record's tag; the thread is in the others.
enum class TapRecord : std::uint32_t {
  row,    // as the loop made it
  event,  // its time [ns], then the CDR message
  end     // of the run
};

/// What is needed to understand a run's rows.
struct RunDescription {
  int number = 0;                  // from 1
  std::vector<RowLayout> layouts;  // of each thread
  std::vector<stream::Topic> topics;
  std::uint64_t epoch_ns = 0;  // added to times: 0 in virtual time
  std::string log;             // that the session writes, or ""
};

/// One run on its way to the server.
struct StreamRun : RunDescription {
  StreamRun(RunDescription description, std::size_t capacity, std::size_t largest)
      : RunDescription(std::move(description)), ring(capacity, largest) {}

  BroadcastRing ring;  // from the thread that reads the loop's rows to the server
  BroadcastRing::Cursor cursor{ring, BroadcastRing::Cursor::Start::oldest};  // the server's
};

}  // namespace trocar::foxglove
