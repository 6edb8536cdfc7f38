// SPDX-License-Identifier: Apache-2.0
#include "cli/run_peaks.hpp"

#include <algorithm>
#include <cmath>

namespace trocar::cli {
namespace {

/// The numbers of an output's row from `offset` [bytes] on; empty where it has no row.
std::vector<RowSignal> numbers_of(const RowLayout& layout, const OutputPort& output,
                                  std::size_t offset, std::size_t count) {
  const std::string name = output.owner_name() + "." + output.name();
  for (const RowPort& port : layout.ports()) {
    if (port.name != name) continue;
    std::vector<RowSignal> numbers = layout.signals();
    std::erase_if(numbers, [&](const RowSignal& signal) {
      return signal.row_offset < port.row_offset + offset ||
             signal.row_offset >= std::min(port.row_offset + port.size,
                                           port.row_offset + offset + count * sizeof(double));
    });
    return numbers;
  }
  return {};
}

}  // namespace

void RunPeaks::begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) {
  constexpr std::size_t axes = 3;
  for (const RateGroup& group : graph.groups()) {
    for (const ScheduleItem& item : group.schedule()) {
      const auto& placement = item.component->placement();
      if (!placement || placement->force == nullptr) continue;
      add(layouts, *placement->force, 0, axes, false, nullptr);
      if (placement->velocity == nullptr) continue;
      for (const Source& source : placement->velocity->sources())
        add(layouts, *source.output, source.offset, axes, false, nullptr);
    }
    for (const Device* device : group.devices())
      add(layouts, device->effort_sent_port(), 0, static_cast<std::size_t>(device->limits().axes),
          true, device->limits().effort.axis);
  }
  add_laws(layouts);
}

/// @param limits of each number, or null
void RunPeaks::add(const std::vector<RowLayout>& layouts, const OutputPort& output,
                   std::size_t offset, std::size_t count, bool one_by_one, const double* limits) {
  for (std::size_t group = 0; group < layouts.size(); ++group) {
    const std::vector<RowSignal> numbers = numbers_of(layouts[group], output, offset, count);
    if (numbers.empty()) continue;
    const std::string& first = numbers.front().name;
    const std::string whole = first.substr(0, first.rfind('.'));
    if (std::any_of(tracked_.begin(), tracked_.end(),
                    [&](const Tracked& one) { return one.peak.name == whole; }))
      return;
    if (!one_by_one) {
      tracked_.push_back({{.name = whole, .unit = numbers.front().unit.symbol}, group, numbers});
      return;
    }
    for (std::size_t i = 0; i < numbers.size(); ++i)
      tracked_.push_back({{.name = numbers[i].name,
                           .unit = numbers[i].unit.symbol,
                           .limit = limits == nullptr ? std::nullopt : std::optional(limits[i])},
                          group,
                          {numbers[i]}});
    return;
  }
}

void RunPeaks::add_laws(const std::vector<RowLayout>& layouts) {
  for (std::size_t group = 0; group < layouts.size(); ++group)
    for (const RowSignal& signal : layouts[group].signals())
      if (signal.name.ends_with(".script.allocations") || signal.name.ends_with(".script.memory"))
        tracked_.push_back({{.name = signal.name, .unit = ""}, group, {signal}, true});
}

void RunPeaks::row(std::size_t group, std::span<const std::byte> row) {
  for (Tracked& one : tracked_) {
    if (one.group != group) continue;
    double squares = 0.0;
    for (const RowSignal& signal : one.numbers) {
      const double value = signal_value(row, signal);
      squares += value * value;
    }
    const double size = std::sqrt(squares);
    if (!(std::isfinite(size) && size > one.peak.value)) continue;
    one.peak.value = size;
    one.peak.time = static_cast<double>(header_of(row).time) * 1e-9;
  }
}

std::vector<RunPeak> RunPeaks::of(bool law) const {
  std::vector<RunPeak> peaks;
  for (const Tracked& one : tracked_)
    if (one.law == law) peaks.push_back(one.peak);
  return peaks;
}

}  // namespace trocar::cli
