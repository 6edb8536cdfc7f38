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

/// One run on its way to the server: its rows in a ring, and what is needed to understand them.
struct StreamRun {
  StreamRun(std::vector<RowLayout> rows, std::vector<stream::Topic> connections,
            std::uint64_t epoch, std::size_t capacity, std::size_t largest)
      : layouts(std::move(rows)),
        topics(std::move(connections)),
        epoch_ns(epoch),
        ring(capacity, largest) {}

  const std::vector<RowLayout> layouts;  // of each thread
  const std::vector<stream::Topic> topics;
  const std::uint64_t epoch_ns;  // added to times: 0 in virtual time
  BroadcastRing ring;            // from the thread that reads the loop's rows to the server
  BroadcastRing::Cursor cursor{ring, BroadcastRing::Cursor::Start::oldest};  // the server's
};

}  // namespace trocar::foxglove
