// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

enum class FaultCause {
  not_finite,
  hold_beyond_limit,
  handle_wrench,
  speed,
  workspace,
  encoder_jump,
  position_lost,
  overload,
  loop_stalled,
  device_fault,
  component_failed,
  signal_lost,
  queue_full,
  operator_stop,
};

/// "not finite", "speed", …: as reports and logs print it.
const char* to_string(FaultCause cause) RT_SAFE;

/// Something that went wrong: what, who, when. Texts live as long as the graph.
struct Fault {
  FaultCause cause = FaultCause::not_finite;
  const char* component = "";
  const char* detail = "";
  double value = 0.0;  // that tripped
  double limit = 0.0;  // that it broke; both 0 where there is none
  std::int64_t tick = 0;
  std::int64_t time_ns = 0;
};

/// The first cause, latched, and what followed it. Wait-free, of fixed size; beyond it faults are
/// counted.
class FaultLatch {
 public:
  static constexpr std::size_t capacity = 64;

  /// A cause that a component raised already, and that nobody acknowledged, is kept once.
  void raise(const Fault& fault) RT_SAFE;
  /// What was raised so far is history; it stays in the list.
  void acknowledge() RT_SAFE { acknowledged_ = count_; }
  bool latched() const RT_SAFE { return count_ > acknowledged_; }
  std::size_t size() const RT_SAFE { return count_ < capacity ? count_ : capacity; }
  std::size_t raised() const RT_SAFE { return count_; }
  const Fault& operator[](std::size_t i) const RT_SAFE { return faults_[i]; }

 private:
  std::array<Fault, capacity> faults_{};
  std::size_t count_ = 0;
  std::size_t acknowledged_ = 0;
};

}  // namespace trocar
