// SPDX-License-Identifier: Apache-2.0
#include "cli/machine.hpp"

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sys/utsname.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "framework/text.hpp"
#include "framework/version.hpp"

namespace trocar::cli {
namespace {

constexpr const char* unreadable = "not readable";

/// The first line, "" when there is none.
std::string line_of(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return std::string(trim(line));
}

std::string line_or(const std::string& path, const std::string& otherwise) {
  const std::string line = line_of(path);
  return line.empty() ? otherwise : line;
}

struct Processors {
  std::string model = unreadable;
  int count = 0;
  bool hypervisor = false;
};

Processors machine_processors(const std::string& root) {
  Processors result;
  std::ifstream file(root + "/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = std::min(line.find(':'), line.size());
    const std::string key(trim(line.substr(0, colon)));
    const std::string value(trim(line.substr(std::min(colon + 1, line.size()))));
    if (key == "processor") ++result.count;
    if (key == "model name") result.model = value;
    if (key == "flags" && (" " + value + " ").find(" hypervisor ") != std::string::npos)
      result.hypervisor = true;
  }
  return result;
}

std::string virtual_machine(const std::string& root, const Processors& all) {
  const std::string product = line_of(root + "/sys/class/dmi/id/product_name");
  const std::string type = line_of(root + "/sys/hypervisor/type");
  const std::string name = type.empty() ? product : type;
  if (all.hypervisor || !type.empty())
    return "yes" + (name.empty() ? std::string() : " (" + name + ")") +
           ": its host takes processors away at will";
  return "not as far as the processor says";
}

/// "full" of "none voluntary (full)"; the kernel's own name for it where that is not readable.
std::string preemption(const std::string& root, const std::string& version) {
  if (line_of(root + "/sys/kernel/realtime") == "1") return "PREEMPT_RT";
  const std::string models = line_of(root + "/sys/kernel/debug/sched/preempt");
  const std::size_t open = models.find('('), close = models.find(')');
  const std::string chosen =
      open < close && close != std::string::npos ? models.substr(open + 1, close - open - 1) : "";
  for (const char* model : {"PREEMPT_RT", "PREEMPT_DYNAMIC", "PREEMPT"})
    if (version.find(model) != std::string::npos)
      return std::string(model) + (chosen.empty() ? "" : ", " + chosen);
  return "none that the kernel's version names";
}

std::string machine_governor(const std::string& root) {
  std::set<std::string> all;
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator(root + "/sys/devices/system/cpu", error))
    if (const std::string one = line_of(entry.path() / "cpufreq/scaling_governor"); !one.empty())
      all.insert(one);
  return all.empty() ? "none: the kernel does not set the frequency"
                     : join({all.begin(), all.end()}, ", ");
}

std::string machine_real_time_limit(const std::string& root) {
  const std::string kernel = root + "/proc/sys/kernel/";
  const std::string runtime = line_of(kernel + "sched_rt_runtime_us");
  if (runtime.empty()) return unreadable;
  if (runtime == "-1") return "no limit (sched_rt_runtime_us = -1)";
  return fmt::format("{} of {} µs (sched_rt_runtime_us)", runtime,
                     line_or(kernel + "sched_rt_period_us", "?"));
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

std::vector<MachineFact> machine_facts(const std::string& root) {
  utsname kernel{};
  uname(&kernel);
  const Processors all = machine_processors(root);
  const std::string devices = root + "/sys/devices/system/";
  return {
      {"kernel", "kernel", fmt::format("{} {} {}", kernel.sysname, kernel.release, kernel.machine)},
      {"preemption", "preemption", preemption(root, kernel.version)},
      {"clock_source", "clock source",
       line_or(devices + "clocksource/clocksource0/current_clocksource", unreadable)},
      {"processor", "processors", fmt::format("{} × {}", all.count, all.model)},
      {"virtual_machine", "virtual machine", virtual_machine(root, all)},
      {"governor", "frequency governor", machine_governor(root)},
      {"isolated", "isolated processors", line_or(devices + "cpu/isolated", "none")},
      {"load", "load average", line_or(root + "/proc/loadavg", unreadable)},
      {"real_time_limit", "real-time threads may take", machine_real_time_limit(root)},
      {"versions", "versions",
       fmt::format("trocar {}, {}, glibc {}", version(), compiler(), gnu_get_libc_version())}};
}

ProcessorTimes ProcessorTimes::now(const std::string& root) {
  std::istringstream line(line_of(root + "/proc/stat"));
  std::string name;
  std::uint64_t user = 0, nice = 0, system = 0, idle = 0, wait = 0, irq = 0, soft = 0, stolen = 0;
  line >> name >> user >> nice >> system >> idle >> wait >> irq >> soft >> stolen;
  return {user + nice + system + idle + wait + irq + soft + stolen, idle + wait, stolen};
}

std::string load_between(const ProcessorTimes& begin, const ProcessorTimes& end) {
  if (end.all <= begin.all) return unreadable;
  const double all = static_cast<double>(end.all - begin.all);
  const auto share = [&](std::uint64_t from, std::uint64_t to) {
    return 100.0 * static_cast<double>(to - from) / all;
  };
  return fmt::format("{:.0f} % busy, {:.1f} % stolen by the host",
                     100.0 - share(begin.idle, end.idle), share(begin.stolen, end.stolen));
}

}  // namespace trocar::cli
