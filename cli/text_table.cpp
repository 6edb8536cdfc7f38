// SPDX-License-Identifier: Apache-2.0
#include "cli/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "framework/text.hpp"

namespace trocar::cli {
namespace {

constexpr std::size_t gap = 2;
constexpr std::size_t narrowest = 20;  // that a wrapping column gets

std::string blanks(std::size_t count) {
  return std::string(count, ' ');
}

std::vector<std::string> lines_of(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  for (const std::string_view paragraph : split(text, '\n')) {
    std::string line;
    for (const std::string_view word : split(paragraph, ' ')) {
      if (!line.empty() && display_width(line) + 1 + display_width(word) > width) {
        lines.push_back(std::move(line));
        line.clear();
      }
      if (!line.empty()) line += ' ';
      line += word;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::size_t display_width(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
  std::string result;
  for (const std::string& line : lines_of(text, width - indent))
    result += blanks(line.empty() ? 0 : indent) + line + '\n';
  return result;
}

std::string TextTable::text() const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], display_width(row[i]));
  }
  std::string result;
  for (const auto& row : rows_) {
    std::string line = blanks(indent_);
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      const std::string pad = blanks(widths[i] - display_width(row[i]));
      const bool at_right = i < right_.size() && right_[i] == 'r';
      line += (at_right ? pad + row[i] : row[i] + pad) + blanks(gap);
    }
    const std::size_t start = display_width(line);
    const std::size_t room =
        std::max(narrowest, terminal_width > start ? terminal_width - start : 0);
    for (const std::string& part : lines_of(row.empty() ? "" : row.back(), room)) {
      line += part;
      line.erase(line.find_last_not_of(' ') + 1);
      result += line + '\n';
      line = blanks(start);
    }
  }
  return result;
}

std::string counted(std::uint64_t count, std::string_view what) {
  std::string digits = fmt::format("{}", count);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, ',');
  return fmt::format("{} {}{}", digits, what, count == 1 ? "" : "s");
}

std::string byte_text(std::uint64_t bytes) {
  constexpr std::array units = {"kB", "MB", "GB", "TB"};
  if (bytes < 1000) return fmt::format("{} B", bytes);
  double size = static_cast<double>(bytes) / 1000.0;
  std::size_t unit = 0;
  while (size >= 999.5 && unit + 1 < units.size()) {
    size /= 1000.0;
    ++unit;
  }
  return fmt::format("{:.3g} {}", size, units[unit]);
}

}  // namespace trocar::cli
