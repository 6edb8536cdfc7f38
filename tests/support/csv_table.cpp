// SPDX-License-Identifier: Apache-2.0
#include "tests/support/csv_table.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace trocar::test {
namespace {

std::vector<std::string> split(std::string line) {
  if (line.ends_with('\r')) line.pop_back();
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

CsvTable::CsvTable(const std::string& path) : path_(path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error(path + ": cannot be read");
  for (const std::string& name : split(line)) columns_.emplace(name, columns_.size());
  while (std::getline(file, line)) {
    rows_.emplace_back(*this, split(line));
    if (split(line).size() != columns_.size())
      throw std::runtime_error(path + ": a row has another number of cells than the header");
  }
}

const std::string& CsvTable::Row::text(const std::string& column) const {
  const auto found = table_->columns_.find(column);
  if (found == table_->columns_.end())
    throw std::runtime_error(table_->path_ + ": no column " + column);
  return cells_[found->second];
}

double CsvTable::Row::number(const std::string& column) const {
  return std::stod(text(column));
}

Eigen::VectorXd CsvTable::Row::vector(const std::vector<std::string>& columns) const {
  Eigen::VectorXd v(static_cast<Eigen::Index>(columns.size()));
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = number(columns[static_cast<std::size_t>(i)]);
  return v;
}

Eigen::MatrixXd CsvTable::Row::matrix(const std::string& prefix, int rows, int columns) const {
  Eigen::MatrixXd m(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      m(i, j) = number(prefix + std::to_string(i + 1) + std::to_string(j + 1));
  return m;
}

Eigen::VectorXd CsvTable::Row::vector(const std::string& prefix, int size) const {
  Eigen::VectorXd v(size);
  for (int i = 0; i < size; ++i) v[i] = number(prefix + std::to_string(i + 1));
  return v;
}

}  // namespace trocar::test
