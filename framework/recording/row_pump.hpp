// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "framework/realtime/broadcast_ring.hpp"
#include "framework/realtime/mailbox.hpp"
#include "framework/recording/row_sink.hpp"

namespace trocar {

/// What came of the readers of a run, in the order in which they were given.
struct PumpResult {
  std::vector<std::string> failures;  // of sinks that threw
  std::vector<ReaderLoss> losses;     // of sinks that fell behind
};

/// Carries rows and events from the loop's rings to the sinks. Each sink has a cursor for each ring
/// and an ordinary thread of its own, so that a slow disk delays nobody else; nobody wakes these
/// threads. A sink that throws is left out from then on; the others and the loop go on.
class RowPump {
 public:
  /// Before the loop begins: begins the sinks.
  /// @param lossless for virtual time: the loop waits for the slowest sink
  RowPump(std::deque<BroadcastRing>& rings, const std::vector<RowSink*>& sinks,
          const std::vector<RowLayout>& layouts, const WiredGraph& graph, bool lossless);
  ~RowPump();
  RowPump(const RowPump&) = delete;
  RowPump& operator=(const RowPump&) = delete;

  /// Sinks that threw since the last call, while the loop goes on.
  std::deque<ReaderFailure> take_failures() { return failures_.take_all(); }
  /// When the loop has ended: carries the rest and ends the sinks.
  PumpResult finish();

 private:
  class Feed;

  Mailbox<ReaderFailure> failures_{64};
  std::vector<std::unique_ptr<Feed>> feeds_;
};

/// A ring for the rows of a thread: what 5 s of rows take in real time, at least 8 MiB and at most
/// 256 MiB; 8 MiB in virtual time, where the loop waits for its readers. Always 64 rows.
std::size_t ring_capacity(const RowLayout& layout, double period, bool lossless);

}  // namespace trocar
