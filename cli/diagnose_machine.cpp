// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "cli/diagnosis.hpp"
#include "cli/machine.hpp"
#include "framework/realtime/throttling.hpp"

namespace trocar::cli {
namespace {

using Level = Diagnosis::Level;

constexpr const char* clock_source_folder = "/sys/devices/system/clocksource/clocksource0/";

Diagnosis kernel(const std::string& preemption, const std::string& name) {
  if (preemption == "PREEMPT_RT") return {"kernel", Level::good, name + ", PREEMPT_RT", ""};
  return {"kernel", Level::note,
          fmt::format("{} has no PREEMPT_RT ({}): a tick can be late by milliseconds when the "
                      "kernel is busy; `trocar bench` measures how often",
                      name, preemption),
          "sudo apt install linux-image-rt-amd64    # then boot it"};
}

/// Reading the clock takes 25 ns from a register, and a microsecond from a chip beside.
Diagnosis clock_source(const std::string& source) {
  if (source == "tsc" || source == "kvm-clock" || source == "arch_sys_counter")
    return {"clock_source", Level::good, "clock source " + source, ""};
  if (source == "not readable")
    return {"clock_source", Level::note, "the clock source is not readable", ""};
  return {
      "clock_source", Level::warning,
      fmt::format("clock source {}: reading it costs microseconds in each tick", source),
      fmt::format("echo tsc | sudo tee {}current_clocksource    # where {}available_clocksource "
                  "has it; else boot with tsc=reliable",
                  clock_source_folder, clock_source_folder)};
}

Diagnosis governor(const std::string& governors) {
  if (governors.starts_with("none") || governors == "performance")
    return {"governor", Level::good, "frequency governor " + governors, ""};
  return {"governor", Level::warning,
          fmt::format("frequency governor {}: a loop that sleeps most of the time runs slowly, and "
                      "not alike each time",
                      governors),
          "echo performance | sudo tee /sys/devices/system/cpu/cpu*/cpufreq/scaling_governor"};
}

Diagnosis virtual_machine(const std::string& said) {
  if (!said.starts_with("yes")) return {"virtual_machine", Level::good, "no virtual machine", ""};
  return {"virtual_machine", Level::warning,
          "a virtual machine, whose host takes processors away at will", "use the host itself"};
}

Diagnosis processors(const std::string& said) {
  if (!said.starts_with("1 ×") && !said.starts_with("0 ×"))
    return {"processors", Level::good, said, ""};
  return {"processors", Level::warning,
          "one processor: the device's threads, recording and the loop take turns on it",
          "use a machine with two or more"};
}

Diagnosis real_time_limit(const std::string& root) {
  const double share = real_time_share(root + "/proc/sys/kernel");
  if (!(share < 1.0))
    return {"real_time_limit", Level::good, "real-time threads may take a processor whole", ""};
  return {"real_time_limit", Level::note,
          fmt::format("real-time threads are halted after {:.0f} % of each second: a loop that "
                      "sleeps never gets there, one that spins may",
                      100.0 * share),
          "sudo sysctl kernel.sched_rt_runtime_us=-1"};
}

}  // namespace

std::vector<Diagnosis> diagnose_machine(const std::string& root) {
  const std::vector<MachineFact> facts = machine_facts(root);
  const auto value = [&](std::string_view key) {
    const auto found = std::find_if(facts.begin(), facts.end(),
                                    [&](const MachineFact& fact) { return fact.key == key; });
    return found == facts.end() ? std::string() : found->value;
  };
  return {kernel(value("preemption"), value("kernel")),
          clock_source(value("clock_source")),
          processors(value("processor")),
          virtual_machine(value("virtual_machine")),
          governor(value("governor")),
          real_time_limit(root)};
}

}  // namespace trocar::cli
