// SPDX-License-Identifier: Apache-2.0
#include "cli/intervention.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "cli/output.hpp"

namespace trocar::cli {

Intervention::Intervention(bool console) {
  if (console)
    lines_.emplace("> ");
  else
    keyboard_.emplace();
}

void Intervention::add_to(SessionOptions& options) {
  if (lines_) {
    options.operator_input = [this](RunControl& control) { return answer_line(control); };
    options.watch = &rows_;
  } else if (keyboard_->there()) {
    options.operator_input = [this](RunControl& control) { return obey_key(control); };
    fmt::print(stderr, "{}\n", Keyboard::help);
  }
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
  return true;
}

}  // namespace trocar::cli
