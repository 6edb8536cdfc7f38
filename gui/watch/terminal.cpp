// SPDX-License-Identifier: Apache-2.0
#include "gui/watch/terminal.hpp"

#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <csignal>
#include <string_view>

namespace trocar::gui {
namespace {

termios before;  // the terminal's settings; a signal handler has no other way to them
volatile std::sig_atomic_t changed = 0, drawn = 0;

void write_out(std::string_view text) {
  [[maybe_unused]] const ssize_t written = write(STDOUT_FILENO, text.data(), text.size());
}

winsize size_now() {
  winsize size{.ws_row = 24, .ws_col = 80, .ws_xpixel = 0, .ws_ypixel = 0};
  ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
  return size;
}

}  // namespace

void restore_terminal() {
  if (changed) tcsetattr(STDIN_FILENO, TCSANOW, &before);
  changed = 0;
  if (drawn) write_out("\033[?1049l\033[?25h");
  drawn = 0;
}

Terminal::Terminal() {
  // A job in the background that touched the terminal would be stopped by the kernel.
  const bool ours = isatty(STDIN_FILENO) != 0 && tcgetpgrp(STDIN_FILENO) == getpgrp();
  if (ours && tcgetattr(STDIN_FILENO, &before) == 0) {
    termios keys = before;
    keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    keys.c_cc[VMIN] = 1;
    keys.c_cc[VTIME] = 0;
    changed = 1;
    tcsetattr(STDIN_FILENO, TCSANOW, &keys);
    keys_ = std::make_unique<QSocketNotifier>(STDIN_FILENO, QSocketNotifier::Read);
    connect(keys_.get(), &QSocketNotifier::activated, this, [this] {
      char which = 0;
      if (::read(STDIN_FILENO, &which, 1) == 1)
        Q_EMIT key(which);
      else
        keys_->setEnabled(false);
    });
  }
  has_screen_ = isatty(STDOUT_FILENO) != 0;
  if (!has_screen_) return;
  drawn = 1;
  write_out("\033[?1049h\033[?25l");
}

Terminal::~Terminal() {
  restore_terminal();
}

std::size_t Terminal::width() const {
  return size_now().ws_col;
}

std::size_t Terminal::height() const {
  return size_now().ws_row;
}

}  // namespace trocar::gui
