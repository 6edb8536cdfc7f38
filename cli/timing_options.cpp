// SPDX-License-Identifier: Apache-2.0
#include "cli/timing_options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <stdexcept>

#include "cli/output.hpp"
#include "framework/units.hpp"

namespace trocar::cli {
namespace {

/// [s]; "0" needs no unit. Nothing when the text is no time.
std::optional<double> time_of(const std::string& text) {
  if (text == "0") return 0.0;
  try {
    const Quantity quantity = parse_quantity(text);
    if (quantity.unit.dimension == parse_unit("s").dimension) return quantity.value;
  } catch (const UnitError&) {
  }
  return {};
}

double time_or_complain(const std::string& text, const char* option, const char* allowed) {
  if (const std::optional<double> time = time_of(text)) return *time;
  throw CLI::ValidationError(option,
                             fmt::format("{} is no time, e.g. {}", in_quotes(text), allowed));
}

void check(const OverloadSettings& settings, const char* option, const std::string& text) {
  try {
    OverloadMonitor(settings, 1e-3);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError(option, fmt::format("{}: {}", in_quotes(text), error.what()));
  }
}

}  // namespace

void WaitOptions::add_to(CLI::App& command) {
  command.add_option("--spin", spin,
                     "Wait actively for this long before each slot, e.g. 100us (default 0: off); "
                     "less lateness for a part of a processor");
  command.add_flag("--hold-latency", hold_latency,
                   "Keep the processors out of deep sleep (/dev/cpu_dma_latency at 0); less "
                   "lateness for power");
}

void WaitOptions::apply(LoopTiming& timing) const {
  timing.hold_latency = hold_latency;
  if (spin.empty()) return;
  timing.spin = time_or_complain(spin, "--spin", "100us (0 or more, shorter than the period)");
  if (!(timing.spin >= 0.0))
    throw CLI::ValidationError(
        "--spin", in_quotes(spin) + " is negative: 0 (off) or more, shorter than the period");
}

void OverloadOptions::add_to(CLI::App& command) {
  command
      .add_option("--overload", policy,
                  "When ticks take too long: stop rendering (default), end the run as well, or "
                  "ignore it (count only)")
      ->check(CLI::IsMember({"stop", "end", "ignore"}));
  command.add_option("--overload-allowed", allowed,
                     "Ticks a second that may end after the next slot was due (default 20)");
  command.add_option("--overload-longest", longest,
                     "How long no tick may end in time (default 20ms)");
  command.add_option("--overload-grace", grace,
                     "From the start, in which nothing is judged (default 500ms)");
}

void OverloadOptions::apply(LoopTiming& timing) const {
  OverloadSettings& settings = timing.overload;
  settings.policy = policy == "end"      ? OverloadPolicy::end
                    : policy == "ignore" ? OverloadPolicy::ignore
                                         : OverloadPolicy::stop;
  if (!allowed.empty()) {
    const char* end = allowed.data() + allowed.size();
    const auto read = std::from_chars(allowed.data(), end, settings.allowed);
    if (read.ec != std::errc() || read.ptr != end)
      throw CLI::ValidationError("--overload-allowed",
                                 in_quotes(allowed) + " is no whole number from 0 to 10000");
    check(settings, "--overload-allowed", allowed);
  }
  if (!longest.empty()) {
    settings.longest = time_or_complain(longest, "--overload-longest", "20ms");
    check(settings, "--overload-longest", longest);
  }
  if (!grace.empty()) {
    settings.grace = time_or_complain(grace, "--overload-grace", "500ms");
    check(settings, "--overload-grace", grace);
  }
}

}  // namespace trocar::cli
