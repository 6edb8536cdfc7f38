// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "framework/device.hpp"
#include "framework/realtime/heartbeat.hpp"
#include "framework/time_source.hpp"

namespace trocar {

/// How long a loop that moves a device may be silent [ns]: 3 periods, at most 4.8 ms, so that with
/// the quarter that may pass until the next look its devices are told before 6 ms are over, and the
/// firmware's own 8 ms are not. Where one and a half periods are more than that, it is these.
std::int64_t heartbeat_patience(std::int64_t period_ns);

/// Watches the loops that move devices, from a thread of a higher priority. A loop that hangs can
/// make nothing safe by itself: the supervisor tells its devices at once, and the loop, should it
/// come back, finds that it was given up and latches that.
class Supervisor {
 public:
  struct Watched {
    Heartbeat* heartbeat = nullptr;
    std::int64_t patience_ns = 0;
    std::span<Device* const> devices{};
  };

  explicit Supervisor(std::vector<Watched> watched);

  /// One look at all of them.
  void look(std::int64_t now_ns);
  /// Looks again and again until all have ended.
  void run(TimeSource& time);

  bool empty() const { return watched_.empty(); }
  /// From one look to the next [ns]: a quarter of the shortest patience, at least 100 µs.
  std::int64_t interval_ns() const { return interval_ns_; }

 private:
  bool all_ended() const;

  std::vector<Watched> watched_;
  std::int64_t interval_ns_;
};

}  // namespace trocar
