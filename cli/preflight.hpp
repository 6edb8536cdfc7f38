// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "cli/run_peaks.hpp"
#include "framework/session.hpp"

namespace trocar::cli {

/// What a graph's run in virtual time says of one in real time.
struct Preflight {
  RunResult run{};
  std::vector<RunPeak> peaks{};  // of forces, velocities and efforts
  std::vector<RunPeak> laws{};   // what laws took of their own memory

  /// What would trip, and steps that allocate: nothing of it may be.
  std::vector<std::string> failures() const;
  /// Ticks that took longer than their period, here: machines differ.
  std::vector<std::string> warnings() const;
};

/// Runs a script's graph as it would be run first, in virtual time, and writes no files.
/// @param options --set, --for and --seed; `allocations` counts for the thread of the loop
/// @throw BrokenGraph with every finding
Preflight preflight(const Registry& registry, const std::string& script, SessionOptions options,
                    Graph::Overrides arguments);

std::string preflight_text(const Preflight& preflight);
/// Times in s, values in SI.
nlohmann::ordered_json preflight_json(const Preflight& preflight);

}  // namespace trocar::cli
