// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "cli/console.hpp"
#include "cli/keyboard.hpp"
#include "cli/line_input.hpp"
#include "cli/source_watch.hpp"
#include "framework/recording/row_snapshot.hpp"
#include "framework/session.hpp"

namespace trocar::cli {

/// How somebody intervenes while a graph runs in real time: by single keys, or line by line.
class Intervention {
 public:
  /// @param console line by line
  /// @param watch reload laws whose files are saved
  Intervention(bool console, bool watch);
  Intervention(const Intervention&) = delete;
  Intervention& operator=(const Intervention&) = delete;

  /// @param options of a session that this outlives
  void add_to(SessionOptions& options);

 private:
  bool look(RunControl& control);
  bool obey_key(RunControl& control);
  bool answer_line(RunControl& control);

  std::optional<Keyboard> keyboard_;
  std::optional<LineInput> lines_;
  std::optional<SourceWatch> watch_;
  RowSnapshot rows_;
  Console console_{rows_};
};

}  // namespace trocar::cli
