// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trocar::cli {

/// Lines that somebody types, without waiting for them: on a terminal with editing, completion by
/// Tab and a history that lasts, from a pipe as they come. At most one lives at a time, on one
/// thread.
class LineInput {
 public:
  using Complete = std::function<std::vector<std::string>(std::string_view begin)>;

  explicit LineInput(std::string prompt);
  ~LineInput();
  LineInput(const LineInput&) = delete;
  LineInput& operator=(const LineInput&) = delete;

  /// The next line, when one is complete. Never waits.
  std::optional<std::string> next(const Complete& complete);
  /// No line will come any more.
  bool closed() const { return closed_; }

 private:
  bool readable() const;
  std::optional<std::string> next_of_pipe();
  void open_terminal();
  void close_terminal();

  std::string prompt_;
  std::string piped_;  // what was read behind the last line
  bool terminal_ = false;
  bool opened_ = false;
  bool answered_ = false;  // a line was taken, and no prompt shown since
  bool closed_ = false;
};

}  // namespace trocar::cli
