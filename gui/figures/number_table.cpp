// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "framework/text.hpp"
#include "gui/figures/result_file.hpp"

namespace trocar::gui {
namespace {

std::string_view without_return(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

double number_of(std::string_view cell, std::size_t line, const std::string& column) {
  cell = trim(cell);
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size())
    throw FigureError(
        fmt::format("line {}: \"{}\" in column {} is no number", line, cell.substr(0, 40), column));
  return value;
}

}  // namespace

const std::vector<double>* NumberTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : &columns[static_cast<std::size_t>(found - names.begin())];
}

NumberTable read_csv(const std::string& text) {
  NumberTable table;
  std::size_t number = 0;
  for (std::string_view line : split(text, '\n')) {
    ++number;
    line = without_return(line);
    if (line.empty()) continue;
    const std::vector<std::string_view> cells = split(line, ',');
    if (table.names.empty()) {
      for (const std::string_view cell : cells) table.names.emplace_back(trim(cell));
      table.columns.resize(cells.size());
      continue;
    }
    if (cells.size() != table.names.size())
      throw FigureError(fmt::format("line {} has {} cells, the first line names {} columns", number,
                                    cells.size(), table.names.size()));
    for (std::size_t i = 0; i < cells.size(); ++i)
      table.columns[i].push_back(number_of(cells[i], number, table.names[i]));
  }
  return table;
}

}  // namespace trocar::gui
