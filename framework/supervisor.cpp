// SPDX-License-Identifier: Apache-2.0
#include "framework/supervisor.hpp"

#include <algorithm>

namespace trocar {

std::int64_t heartbeat_patience(std::int64_t period_ns) {
  constexpr std::int64_t longest = 4'800'000;  // [ns]
  return std::max(std::min(3 * period_ns, longest), period_ns + period_ns / 2);
}

Supervisor::Supervisor(std::vector<Watched> watched)
    : watched_(std::move(watched)), interval_ns_(100'000) {
  if (watched_.empty()) return;
  const auto shortest = std::min_element(
      watched_.begin(), watched_.end(),
      [](const Watched& a, const Watched& b) { return a.patience_ns < b.patience_ns; });
  interval_ns_ = std::max(interval_ns_, shortest->patience_ns / 4);
}

void Supervisor::look(std::int64_t now_ns) {
  for (Watched& loop : watched_)
    if (loop.heartbeat->gives_up(now_ns, loop.patience_ns))
      for (Device* device : loop.devices) device->loop_stalled();
}

bool Supervisor::all_ended() const {
  return std::all_of(watched_.begin(), watched_.end(),
                     [](const Watched& loop) { return loop.heartbeat->ended(); });
}

void Supervisor::run(TimeSource& time) {
  while (!all_ended()) {
    const std::int64_t now = time.now();
    look(now);
    time.sleep_until(now + interval_ns_);
  }
}

}  // namespace trocar
