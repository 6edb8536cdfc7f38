// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace trocar::test {

/// A CSV file with a header and neither quotes nor empty lines.
class CsvTable {
 public:
  class Row {
   public:
    Row(const CsvTable& table, std::vector<std::string> cells)
        : table_(&table), cells_(std::move(cells)) {}

    const std::string& text(const std::string& column) const;
    double number(const std::string& column) const;

    /// Column vector of the named columns.
    Eigen::VectorXd vector(const std::vector<std::string>& columns) const;

    /// The columns prefix11 .. prefixRC.
    Eigen::MatrixXd matrix(const std::string& prefix, int rows, int columns) const;

    /// The columns prefix1 .. prefixN.
    Eigen::VectorXd vector(const std::string& prefix, int size) const;

   private:
    const CsvTable* table_;
    std::vector<std::string> cells_;
  };

  /// @throw std::runtime_error when the file, a column or a number is missing.
  explicit CsvTable(const std::string& path);
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::string path_;
  std::map<std::string, std::size_t> columns_;
  std::vector<Row> rows_;
};

}  // namespace trocar::test
