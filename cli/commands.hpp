// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

#include "framework/step_cost.hpp"

/// @file
/// The subcommands of `trocar`. Each function adds one; when it runs it sets `status`.

namespace trocar::cli {

/// What `trocar` ends with.
enum ExitStatus : int {
  success = 0,
  failed = 1,  // the run or a check failed
  misused = 2  // wrong usage, or a broken script
};

void add_bench(CLI::App& app, int& status);
/// @param allocations of the calling thread so far, or null where nobody counts
void add_check(CLI::App& app, int& status, AllocationCount allocations);
void add_completion(CLI::App& app, int& status);
void add_describe(CLI::App& app, int& status);
void add_devices(CLI::App& app, int& status);
void add_doctor(CLI::App& app, int& status);
void add_emulate(CLI::App& app, int& status);
void add_graph(CLI::App& app, int& status);
void add_info(CLI::App& app, int& status);
void add_kinematics(CLI::App& app, int& status);
void add_list(CLI::App& app, int& status);
void add_run(CLI::App& app, int& status);
void add_stubs(CLI::App& app, int& status);
void add_test(CLI::App& app, int& status);
void add_watch(CLI::App& app);
void add_workspace(CLI::App& app, int& status);

}  // namespace trocar::cli
