// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace trocar {

/// The names of files of one kind: "touch.mcap", "touch-2.mcap", …; or, where the first has a
/// number, "demo.blackbox-1.mcap", "demo.blackbox-2.mcap", …
class FileSeries {
 public:
  enum class Existing {
    replaced,     // as a log is that is recorded again
    passed_over,  // the next free number is taken
  };
  FileSeries(const std::string& first, Existing existing);

  /// The next name. One that was free is taken at once by an empty file, so that two programs do
  /// not take the same.
  /// @throw std::runtime_error when ten thousand are there already
  std::string next();

 private:
  std::string name(int number) const;

  std::string stem_;
  std::string extension_;
  bool first_is_numbered_ = false;
  Existing existing_;
  int number_ = 1;  // of the next
};

}  // namespace trocar
