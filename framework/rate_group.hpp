// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "framework/crossing.hpp"
#include "framework/device.hpp"

namespace trocar {

/// One component in the order of the schedule.
struct ScheduleItem {
  Component* component = nullptr;
  std::int64_t divider = 1;  // steps at ticks phase, phase + divider, …
  std::int64_t phase = 0;
  std::size_t begin = 0;  // its outputs' numbers in the group's memory: [begin, end)
  std::size_t end = 0;
  unsigned reaches_effort = 0;  // bit d: what the group's d-th device renders is computed from it
  unsigned reaches_hold = 0;    // bit d: what holds the group's d-th device is
  std::uint64_t reaches_crossing = 0;  // bit of a departure: what is sent is
};

/// A value that a component reads from another thread.
struct Arrival {
  Crossing* crossing = nullptr;
  const InputPort* input = nullptr;
  std::size_t item = 0;  // of the schedule, that reads it
  Signature signature;
  const std::byte* value = nullptr;  // in the group's memory
  const std::int64_t* tick = nullptr;
  const bool* valid = nullptr;
};

/// A value that a component sends to another thread.
struct Departure {
  Crossing* crossing = nullptr;
  std::size_t item = 0;    // of the schedule, that makes it
  std::uint64_t mask = 0;  // its bit in reaches_crossing
};

/// What one thread of the loop runs: its components in their order, its devices, what comes from
/// other threads and what goes there. All its values lie in one block of memory, numbers of outputs
/// first, so that a tick's values are looked through and recorded in one pass.
class RateGroup {
 public:
  const std::string& name() const { return name_; }
  const std::vector<ScheduleItem>& schedule() const { return schedule_; }
  const std::vector<Device*>& devices() const { return devices_; }
  const std::vector<Arrival>& arrivals() const { return arrivals_; }
  const std::vector<Departure>& departures() const { return departures_; }
  double period() const { return period_; }
  std::int64_t period_ns() const { return period_ns_; }
  std::int64_t phase_ns() const { return phase_ns_; }  // of slot 0
  int priority() const { return priority_; }
  std::optional<int> processor() const { return processor_; }
  /// All numbers of all outputs.
  std::span<const double> numbers() const { return {memory_.data(), number_count_}; }
  /// Where a placed output begins in the memory [bytes].
  std::size_t offset_of(const OutputPort& output) const { return offset_of(output.data()); }
  std::size_t offset_of(const void* value) const {
    return static_cast<std::size_t>(static_cast<const std::byte*>(value) - memory());
  }
  const std::byte* memory() const { return reinterpret_cast<const std::byte*>(memory_.data()); }
  std::size_t memory_size() const { return memory_.size() * sizeof(double); }

 private:
  friend class Wiring;
  std::string name_;
  std::vector<ScheduleItem> schedule_;
  std::vector<Device*> devices_;
  std::vector<Arrival> arrivals_;
  std::vector<Departure> departures_;
  std::vector<double> memory_;
  std::size_t number_count_ = 0;
  double period_ = 0.0;
  std::int64_t period_ns_ = 0;
  std::int64_t phase_ns_ = 0;
  int priority_ = 80;
  std::optional<int> processor_;
};

}  // namespace trocar
