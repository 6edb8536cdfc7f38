// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace trocar::cli {

/// "workspace  [#####               ]  25 %".
std::string bar_text(std::string_view what, std::size_t done, std::size_t count);

/// A line on the terminal that fills up, rewritten some times a second, and gone at the end.
/// Nothing where standard error is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done, std::size_t count);

 private:
  std::string what_;
  bool on_terminal_;
  bool shown_ = false;
  std::int64_t next_ns_ = 0;
};

}  // namespace trocar::cli
