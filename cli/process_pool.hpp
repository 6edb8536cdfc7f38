// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace trocar::cli {

struct ProcessOutcome {
  std::string answer{};   // what the task returned
  std::string output{};   // what it printed, on either stream
  std::string trouble{};  // "" when it ended; else "ended by signal 11 (Segmentation fault)", …
  double seconds = 0.0;
};

struct ProcessOptions {
  std::size_t at_once = 0;  // 0: as many as there are processors
  double timeout = 60.0;    // [s] of each; then it is killed
};

/// Calls task(0) to task(count - 1), each in a copy of this process, so that none can harm another
/// one. For a process with one thread.
/// @param task runs in the copy and does not throw
/// @param done is told of each as it ends, in this process
/// @throw std::system_error when no process can be made
void run_in_processes(std::size_t count, const ProcessOptions& options,
                      const std::function<std::string(std::size_t)>& task,
                      const std::function<void(std::size_t, ProcessOutcome)>& done);

}  // namespace trocar::cli
