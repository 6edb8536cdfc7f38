// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt.hpp"

#include <csignal>

namespace trocar::cli {
namespace {

StopFlag interrupted;  // a signal handler has no other way to reach it

void interrupt(int) {
  interrupted.raise();
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

const StopFlag& stop_on_interrupt() {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  return interrupted;
}

}  // namespace trocar::cli
