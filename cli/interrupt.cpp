// SPDX-License-Identifier: Apache-2.0
#include "cli/interrupt.hpp"

#include <csignal>

#include "cli/keyboard.hpp"

namespace trocar::cli {
namespace {

StopFlag interrupted;  // a signal handler has no other way to reach it

void interrupt(int signal) {
  if (interrupted.raised()) {  // again: at once, but not with a terminal that shows nothing
    restore_terminal();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  interrupted.raise();
}

}  // namespace

const StopFlag& stop_on_interrupt() {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  return interrupted;
}

}  // namespace trocar::cli
