// SPDX-License-Identifier: Apache-2.0
#include "cli/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "framework/clock.hpp"

namespace trocar::cli {
namespace {

constexpr std::int64_t bar_interval_ns = 100'000'000;
constexpr std::size_t width = 40;  // [characters]

}  // namespace

std::string bar_text(std::string_view what, std::size_t done, std::size_t count) {
  const std::size_t part = std::min(done, count);
  const std::size_t filled = count == 0 ? width : width * part / count;
  return fmt::format("{}  [{:<{}}] {:3} %", what, std::string(filled, '#'), width,
                     count == 0 ? 100 : 100 * part / count);
}

ProgressBar::ProgressBar(std::string what)
    : what_(std::move(what)), on_terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (!shown_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

void ProgressBar::show(std::size_t done, std::size_t count) {
  if (!on_terminal_) return;
  const std::int64_t now = monotonic_ns();
  if (now < next_ns_) return;
  next_ns_ = now + bar_interval_ns;
  const std::string line = "\r  " + bar_text(what_, done, count) + "\033[K";
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace trocar::cli
