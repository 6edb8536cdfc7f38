// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "framework/recording/row_snapshot.hpp"
#include "framework/run_control.hpp"

namespace trocar::cli {

/// Answers what is typed while a graph runs:
///
///   wall.force              the newest values of signals
///   wall.stiffness          a parameter
///   wall.stiffness = 3 N/mm its new value, under a ramp
///   stop, engage, acknowledge, end
///   list [part], help
class Console {
 public:
  explicit Console(const RowSnapshot& rows) : rows_(rows) {}

  /// Lines of text; "" where there is nothing to say.
  std::string answer(std::string_view line, RunControl& control) const;
  /// What a line that begins so could become, in alphabetical order.
  std::vector<std::string> completions(std::string_view begin, RunControl& control) const;

 private:
  std::string answer_set(std::string_view key, std::string_view value, RunControl& control) const;
  std::string answer_list(std::string_view part, RunControl& control) const;
  std::string answer_name(const std::string& name, RunControl& control) const;
  std::string signals_text(const std::string& name) const;

  const RowSnapshot& rows_;
};

}  // namespace trocar::cli
