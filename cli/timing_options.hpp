// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "framework/run.hpp"

namespace trocar::cli {

/// How a loop waits: --spin and --hold-latency.
struct WaitOptions {
  std::string spin;
  bool hold_latency = false;

  void add_to(CLI::App& command);
  /// @throw CLI::ValidationError when the spin is no time
  void apply(LoopTiming& timing) const;
};

/// What follows when it does not keep up: --overload and its limits.
struct OverloadOptions {
  std::string policy = "stop";
  std::string grace;
  std::string longest;
  std::string allowed;

  void add_to(CLI::App& command);
  /// @throw CLI::ValidationError with the option, the value and what is allowed
  void apply(LoopTiming& timing) const;
};

}  // namespace trocar::cli
