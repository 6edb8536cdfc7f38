// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace trocar::cli {

/// What is wrong with a CSV text; the message begins with the line, counted from 1.
struct CsvError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads comma-separated values (RFC 4180) with a header. Empty lines and blanks around a field
/// are ignored, lines end in LF or CRLF, a byte order mark is skipped.
class CsvReader {
 public:
  /// Reads the header. @throw CsvError when it is missing, or names a column twice.
  explicit CsvReader(std::istream& input);

  const std::vector<std::string>& columns() const { return columns_; }
  std::optional<std::size_t> column(std::string_view name) const;

  /// Moves to the next row; false behind the last.
  /// @throw CsvError for quotes that do not match, or another number of fields than the header's.
  bool next();

  std::size_t line() const { return line_; }  // on which the row begins
  const std::string& text(std::size_t column) const { return fields_[column]; }
  /// @throw CsvError with line and column when the field is no number.
  double number(std::size_t column) const;

 private:
  bool read_record();
  bool read_line(std::string& line);
  void split(std::string text);
  [[noreturn]] void fail(const std::string& what) const;

  std::istream& input_;
  std::size_t line_ = 0;  // of the record
  std::size_t lines_read_ = 0;
  std::vector<std::string> columns_;
  std::vector<std::string> fields_;
};

/// A line of CSV as it grows.
class CsvLine {
 public:
  /// In quotes where it needs them.
  CsvLine& add(std::string_view text);
  /// The shortest text that reads back as the same number.
  CsvLine& add(double number);
  std::string text() const { return text_ + "\n"; }

 private:
  void separate();

  std::string text_;
  bool begun_ = false;
};

}  // namespace trocar::cli
