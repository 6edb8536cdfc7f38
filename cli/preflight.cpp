// SPDX-License-Identifier: Apache-2.0
#include "cli/preflight.hpp"

#include <fmt/format.h>

#include <utility>

#include "cli/text_table.hpp"
#include "framework/scripting/script.hpp"

namespace trocar::cli {

Preflight preflight(const Registry& registry, const std::string& script, SessionOptions options,
                    Graph::Overrides arguments) {
  RunPeaks peaks;
  options.clock = ClockKind::simulated;
  options.check_only = true;
  options.write_files = false;
  options.watch = &peaks;
  Session session(registry, std::move(options));
  run_script(session, script, std::move(arguments));
  RunOptions first = session.planned().value_or(RunOptions{});
  first.keep_rows = false;
  first.keep.clear();
  const SessionRun& run = session.run(std::move(first));
  return {run.result, peaks.motion(), peaks.laws()};
}

std::vector<std::string> Preflight::failures() const {
  std::vector<std::string> failures;
  for (const FaultRecord& fault : run.faults) failures.push_back(fault.text());
  for (const ThreadResult& thread : run.threads)
    for (const ComponentTiming& component : thread.components)
      if (component.cost.allocations > 0)
        failures.push_back(fmt::format(
            "{} allocates memory in its steps: {}, the first at tick {}", component.name,
            counted(component.cost.allocations, "allocation"), component.cost.allocation_tick));
  return failures;
}

std::vector<std::string> Preflight::warnings() const {
  std::vector<std::string> warnings;
  for (const ThreadResult& thread : run.threads) {
    const double worst = static_cast<double>(thread.loop.tick_cost.worst_ns) * 1e-9;
    if (worst * thread.rate > 1.0)
      warnings.push_back(fmt::format(
          "tick {} of the thread {} took {:.0f} µs here, longer than its period of {:.0f} µs",
          thread.loop.tick_cost.worst_tick, thread.name, worst * 1e6, 1e6 / thread.rate));
  }
  return warnings;
}

}  // namespace trocar::cli
