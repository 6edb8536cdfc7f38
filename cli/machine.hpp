// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace trocar::cli {

/// Something about the machine that timing depends on.
struct MachineFact {
  std::string key;    // "clock_source", for programs
  std::string label;  // "clock source"
  std::string value;  // "tsc"; "not readable" where the system does not say
};

/// Kernel, preemption, clock source, processors, virtual machine, frequency governor, isolated
/// processors, load, limit of real-time threads, versions; read from /proc and /sys under `root`.
std::vector<MachineFact> machine_facts(const std::string& root = "");

/// What all processors together did since the start, in ticks of the kernel's own count.
struct ProcessorTimes {
  std::uint64_t all = 0;
  std::uint64_t idle = 0;
  std::uint64_t stolen = 0;  // by the host of a virtual machine

  static ProcessorTimes now(const std::string& root = "");
};

/// "41 % busy, 0.3 % stolen by the host" between two looks, or "not readable".
std::string load_between(const ProcessorTimes& begin, const ProcessorTimes& end);

}  // namespace trocar::cli
