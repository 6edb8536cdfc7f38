// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "framework/command.hpp"

namespace trocar::cli {

/// While one lives, the keys of the terminal are an operator's requests:
///
///   space  stop the rendering      a  acknowledge a fault
///   e      engage                  h  home
///   q      end the run
///
/// Keys are taken without Enter and not shown. Where standard input is no terminal, or belongs to
/// another job, there are none.
class Keyboard {
 public:
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  bool there() const { return there_; }
  /// What the next key asks for; nothing when none was pressed. Never waits.
  std::optional<Command::Kind> next();
  static constexpr const char* help =
      "space stops the rendering, a acknowledges a fault, h homes, e engages, q ends the run";

 private:
  bool there_ = false;
};

/// Gives the terminal back as it was; may be called from a signal handler.
void restore_terminal();

}  // namespace trocar::cli
