// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/fault.hpp"
#include "framework/rate_group.hpp"

namespace trocar {

/// What one thread of the loop takes from the others at the beginning of its tick, and sends to
/// them at the end. A value that must not be used is a fault of the component that reads it, and
/// what is computed from it is lost in that tick.
class Exchange {
 public:
  /// Bits as in ScheduleItem.
  struct Lost {
    unsigned effort = 0;
    unsigned hold = 0;
    std::uint64_t crossing = 0;
  };

  Exchange(const RateGroup& group, FaultLatch& faults) : group_(group), faults_(faults) {}

  void receive(const Tick& tick, bool simulated) RT_SAFE {
    lost_ = {};
    for (const Arrival& arrival : group_.arrivals()) receive_one(arrival, tick, simulated);
  }
  /// @param stepped whether the i-th component of the schedule stepped in this tick
  /// @param lost bits of what is computed from values that are not sound, found in this tick
  template <typename Stepped>
  void send(const Tick& tick, std::uint64_t lost, const Stepped& stepped) RT_SAFE {
    for (const Departure& departure : group_.departures()) {
      const bool sound = ((lost | lost_.crossing) & departure.mask) == 0;
      if (stepped(departure.item) || !sound) send_one(departure, tick, sound);
    }
  }
  const Lost& lost() const RT_SAFE { return lost_; }

 private:
  void receive_one(const Arrival& arrival, const Tick& tick, bool simulated) RT_SAFE;
  void send_one(const Departure& departure, const Tick& tick, bool sound) RT_SAFE;

  const RateGroup& group_;
  FaultLatch& faults_;
  Lost lost_{};
};

}  // namespace trocar
