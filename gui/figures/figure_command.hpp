// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

namespace trocar::gui {

/// `--figure KIND IN OUT`: draws the figure of an experiment to a file. It needs no display.
class FigureCommand {
 public:
  static constexpr int failed = 1, misused = 2;  // exit statuses

  /// @param app must outlive the parsing, and this the running
  void add_options(CLI::App& app);
  bool is_asked_for() const { return !what_.empty(); }
  /// Draws, and tells the numbers on standard output. Brings its own QApplication where there is
  /// none, which never looks for a display.
  /// @return the exit status: 0, 1 when a file cannot be read or written, 2 for what is misused
  int run() const;

 private:
  int draw() const;

  std::vector<std::string> what_;  // kind, in, out
  std::vector<std::string> where_;
  int run_ = 1;
  std::string thread_, quantity_;
};

}  // namespace trocar::gui
