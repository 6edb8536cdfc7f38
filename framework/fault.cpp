// SPDX-License-Identifier: Apache-2.0
#include "framework/fault.hpp"

namespace trocar {

const char* to_string(FaultCause cause) RT_SAFE {
  switch (cause) {
    case FaultCause::not_finite:
      return "not finite";
    case FaultCause::hold_beyond_limit:
      return "hold beyond limit";
    case FaultCause::handle_wrench:
      return "handle wrench";
    case FaultCause::speed:
      return "speed";
    case FaultCause::workspace:
      return "workspace";
    case FaultCause::encoder_jump:
      return "encoder jump";
    case FaultCause::position_lost:
      return "position lost";
    case FaultCause::overload:
      return "overload";
    case FaultCause::loop_stalled:
      return "loop stalled";
    case FaultCause::device_fault:
      return "device fault";
    case FaultCause::component_failed:
      return "component failed";
    case FaultCause::signal_lost:
      return "signal lost";
    case FaultCause::queue_full:
      return "queue full";
    case FaultCause::operator_stop:
      return "operator stop";
  }
  return "unknown";
}

void FaultLatch::raise(const Fault& fault) RT_SAFE {
  for (std::size_t i = acknowledged_; i < size(); ++i)
    if (faults_[i].cause == fault.cause && faults_[i].component == fault.component) return;
  if (count_ < capacity) faults_[count_] = fault;
  ++count_;
}

}  // namespace trocar
