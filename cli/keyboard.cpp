// SPDX-License-Identifier: Apache-2.0
#include "cli/keyboard.hpp"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <csignal>

namespace trocar::cli {
namespace {

termios before;  // the terminal's settings; a signal handler has no other way to them
volatile std::sig_atomic_t changed = 0;

/// A job in the background that touched the terminal would be stopped by the kernel.
bool ours() {
  return isatty(STDIN_FILENO) != 0 && tcgetpgrp(STDIN_FILENO) == getpgrp();
}

}  // namespace

void restore_terminal() {
  if (changed) tcsetattr(STDIN_FILENO, TCSANOW, &before);
  changed = 0;
}

Keyboard::Keyboard() {
  if (!ours() || tcgetattr(STDIN_FILENO, &before) != 0) return;
  termios keys = before;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  keys.c_cc[VMIN] = 1;
  keys.c_cc[VTIME] = 0;
  changed = 1;
  there_ = tcsetattr(STDIN_FILENO, TCSANOW, &keys) == 0;
}

Keyboard::~Keyboard() {
  restore_terminal();
}

std::optional<Command::Kind> Keyboard::next() {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  if (!there_ || !ours() || poll(&input, 1, 0) != 1 || (input.revents & POLLIN) == 0)
    return std::nullopt;
  char key = 0;
  if (read(STDIN_FILENO, &key, 1) != 1) return std::nullopt;
  switch (key) {
    case ' ':
      return Command::Kind::stop_rendering;
    case 'a':
      return Command::Kind::acknowledge;
    case 'e':
      return Command::Kind::engage;
    case 'h':
      return Command::Kind::home;
    case 'q':
      return Command::Kind::end;
    default:
      return std::nullopt;
  }
}

}  // namespace trocar::cli
