// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "framework/realtime/background_poller.hpp"
#include "framework/realtime/record_ring.hpp"
#include "framework/recording/row_sink.hpp"

namespace trocar {

/// Carries rows and events from the loop's ring to the sinks, on an ordinary thread. A sink that
/// throws is left out from then on; the others and the loop go on.
class RowPump {
 public:
  /// Before the loop begins: begins the sinks.
  RowPump(RecordRing& ring, std::vector<RowSink*> sinks, const RowLayout& layout,
          const WiredGraph& graph);

  /// When the loop has ended: carries the rest and ends the sinks.
  /// @return what went wrong in sinks
  std::vector<std::string> finish();

 private:
  bool drain();
  template <typename Deliver>
  void for_each_sink(const Deliver& deliver);

  RecordRing& ring_;
  std::vector<RowSink*> sinks_;
  std::vector<std::string> failures_;
  BackgroundPoller poller_;  // last: it uses all of the above
};

}  // namespace trocar
