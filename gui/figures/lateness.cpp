// SPDX-License-Identifier: Apache-2.0
#include "gui/figures/lateness.hpp"

#include <fmt/format.h>

#include "framework/realtime/timing_histogram.hpp"

namespace trocar::gui {

Lateness lateness_of(const ResultFile& file, int run, const std::string& thread) {
  if (file.log() == nullptr)
    throw FigureError("lateness needs the rows of a log (.mcap); this is " + file.contents());
  TimingHistogram histogram;
  const auto rows = file.signals_of({"lateness"}, run, thread);
  for (const double late : rows.at("lateness")) histogram.add(static_cast<std::int64_t>(late));
  if (histogram.max() == 0)
    throw FigureError(
        "no tick is late in this log: lateness needs one that was recorded in real time");
  const auto seconds = [](std::int64_t nanoseconds) {
    return 1e-9 * static_cast<double>(nanoseconds);
  };
  Lateness lateness{.bins = {},
                    .count = histogram.count(),
                    .p50 = seconds(histogram.percentile(0.5)),
                    .p99 = seconds(histogram.percentile(0.99)),
                    .p999 = seconds(histogram.percentile(0.999)),
                    .max = seconds(histogram.max())};
  for (const TimingHistogram::Bin& bin : histogram.bins())
    lateness.bins.push_back({seconds(bin.lower), seconds(bin.upper + 1), bin.count});
  return lateness;
}

std::string lateness_text(const Lateness& lateness) {
  return fmt::format(
      "{} ticks began late by {:.4g} µs (median), {:.4g} µs (99 %), {:.4g} µs (99.9 %), {:.4g} µs "
      "at worst",
      lateness.count, 1e6 * lateness.p50, 1e6 * lateness.p99, 1e6 * lateness.p999,
      1e6 * lateness.max);
}

}  // namespace trocar::gui
