// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trocar::cli {

inline constexpr std::size_t terminal_width = 80;  // [characters]

/// Columns of text under each other, two blanks apart. The last one wraps at the terminal's width;
/// a line end in it begins a new line there.
class TextTable {
 public:
  /// @param right which columns stand at the right, e.g. "lr": the second
  explicit TextTable(std::string right = "", std::size_t indent = 2)
      : right_(std::move(right)), indent_(indent) {}

  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  bool empty() const { return rows_.empty(); }
  std::string text() const;

 private:
  std::string right_;
  std::size_t indent_;
  std::vector<std::vector<std::string>> rows_;
};

/// `text` in lines of at most `width`, each behind `indent` blanks; words stay whole.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width = terminal_width);

/// Characters, not bytes.
std::size_t display_width(std::string_view utf8);

/// "1 row", "12,345 rows".
std::string counted(std::uint64_t count, std::string_view what);

/// "734 B", "1.25 MB".
std::string byte_text(std::uint64_t bytes);

}  // namespace trocar::cli
