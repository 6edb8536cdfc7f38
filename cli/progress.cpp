// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "framework/clock.hpp"

namespace trocar::cli {
namespace {

constexpr std::int64_t interval_ns = 200'000'000;
constexpr int rows_between_looks = 64;  // a look at the clock costs as much as a row

}  // namespace

void Progress::begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) {
  *this = {};
  for (std::size_t group = 0; group < layouts.size(); ++group)
    for (const ScheduleItem& item : graph.groups()[group].schedule()) {
      const auto& placement = item.component->placement();
      if (!placement || placement->force == nullptr) continue;
      const std::string name = item.component->name() + "." + placement->force->name();
      for (const RowPort& port : layouts[group].ports())
        if (port.name == name) forces_.push_back({group, port.row_offset});
    }
}

void Progress::row(std::size_t group, std::span<const std::byte> row) {
  worst_lateness_ = std::max(worst_lateness_, header_of(row).lateness);
  for (Force& force : forces_)
    if (force.group == group)
      force.now =
          Eigen::Vector3d(number_at(row, force.row_offset), number_at(row, force.row_offset + 8),
                          number_at(row, force.row_offset + 16))
              .norm();
  if (++rows_since_look_ < rows_between_looks) return;
  rows_since_look_ = 0;
  const std::int64_t now = monotonic_ns();
  if (now < next_ns_) return;
  next_ns_ = now + interval_ns;
  show(static_cast<double>(header_of(row).time) * 1e-9);
}

void Progress::show(double time) {
  double largest = 0.0;
  for (const Force& force : forces_) largest = std::max(largest, force.now);
  fmt::print(stderr,
             "\r  {:8.2f} s   force {:6.2f} N   worst lateness {:5.0f} µs   faults {}\033[K", time,
             largest, static_cast<double>(worst_lateness_) * 1e-3, faults_);
  std::fflush(stderr);
  shown_ = true;
}

void Progress::event(std::size_t, const Event& event) {
  if (event.kind == Event::Kind::fault) ++faults_;
}

void Progress::end() {
  if (shown_) fmt::print(stderr, "\r\033[K");
}

}  // namespace trocar::cli
