// SPDX-License-Identifier: Apache-2.0
#include "cli/source_watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <utility>

#include "framework/clock.hpp"

namespace trocar::cli {
namespace {

constexpr std::int64_t watch_interval_ns = 200'000'000;

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

void SourceWatch::tell(const std::string& text) const {
  static const bool terminal = isatty(STDERR_FILENO) == 1;
  fmt::print(stderr, "{}{}\n", terminal ? "\r\033[K" : "", text);
}

bool SourceWatch::look(RunControl& control) {
  bool found = false;
  for (const ReloadVerdict& verdict : control.reload_troubles()) {
    tell(fmt::format("{}: undone, the version before goes on: {}", verdict.component,
                     verdict.trouble));
    found = true;
  }
  const std::int64_t now = monotonic_ns();
  if (now < next_ns_) return found;
  next_ns_ = now + watch_interval_ns;
  const std::vector<Reloads::Part> parts = control.parts();
  for (const Reloads::Part& part : parts) found = reload(part, control) || found;
  if (!std::exchange(told_, true)) tell_what_is_watched(parts);
  return found;
}

void SourceWatch::tell_what_is_watched(const std::vector<Reloads::Part>& parts) {
  if (parts.empty()) tell("--watch: no component's law comes from a file");
  for (const Reloads::Part& part : parts)
    tell(fmt::format("{}: reloads {} when it is saved", part.component, part.file));
}

bool SourceWatch::reload(const Reloads::Part& part, RunControl& control) {
  std::error_code gone;  // for a moment, where an editor writes a new file in its place
  const auto written = std::filesystem::last_write_time(part.file, gone);
  if (gone) return false;
  const auto [known, first] = seen_.try_emplace(part.component, written);
  if (first || known->second == written) return false;
  std::ifstream file(part.file, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  if (!file || text.str().empty()) return false;  // it is being written: the next look will see it
  known->second = written;
  const std::string trouble = control.reload({.component = part.component,
                                              .file = file_name(part.file),
                                              .path = part.file,
                                              .text = text.str()});
  tell(trouble.empty()
           ? fmt::format("{}: {} takes over", part.component, file_name(part.file))
           : fmt::format("{}: refused, the version before goes on: {}", part.component, trouble));
  return true;
}

}  // namespace trocar::cli
