// SPDX-License-Identifier: Apache-2.0
#include "cli/intervention.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "cli/output.hpp"

namespace trocar::cli {

Intervention::Intervention(bool console, bool watch) {
  if (watch) watch_.emplace();
  if (console)
    lines_.emplace("> ");
  else
    keyboard_.emplace();
}

void Intervention::add_to(SessionOptions& options) {
  options.reloadable = watch_.has_value();
  if (lines_) options.watch = &rows_;
  if (keyboard_ && keyboard_->there()) fmt::print(stderr, "{}\n", Keyboard::help);
  if (lines_ || watch_ || keyboard_->there())
    options.operator_input = [this](RunControl& control) { return look(control); };
}

bool Intervention::look(RunControl& control) {
  const bool found = watch_ && watch_->look(control);
  if (lines_) return answer_line(control) || found;
  return obey_key(control) || found;
}

bool Intervention::obey_key(RunControl& control) {
  const auto kind = keyboard_->next();
  if (kind) control.request(*kind);
  return kind.has_value();
}

bool Intervention::answer_line(RunControl& control) {
  const auto line =
      lines_->next([&](std::string_view begin) { return console_.completions(begin, control); });
  if (!line) return false;
  print(console_.answer(*line, control));
  std::fflush(stdout);  // whoever asks through pipes waits for it
  return true;
}

}  // namespace trocar::cli
