// SPDX-License-Identifier: Apache-2.0
#include "cli/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "cli/output.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

void strip(std::string_view& text) {
  while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
}

}  // namespace

CsvReader::CsvReader(std::istream& input) : input_(input) {
  if (!read_record())
    throw CsvError("line 1: the input is empty, a header with the columns' names is needed");
  columns_ = fields_;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (!columns_[i].empty() && *column(columns_[i]) != i)
      fail(fmt::format("column {} stands twice in the header", in_quotes(columns_[i])));
  if (columns_.size() == 1 && columns_[0].find(';') != std::string::npos)
    fail("the header has no comma: separate the columns by commas, not semicolons");
}

std::optional<std::size_t> CsvReader::column(std::string_view name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

bool CsvReader::next() {
  if (!read_record()) return false;
  if (fields_.size() != columns_.size())
    fail(fmt::format("the row has {} field{}, the header has {}", fields_.size(),
                     fields_.size() == 1 ? "" : "s", columns_.size()));
  return true;
}

double CsvReader::number(std::size_t column) const {
  const std::string& field = fields_[column];
  const auto refuse = [&](const std::string& why) {
    fail(fmt::format("column {}: {}", in_quotes(columns_[column]), why));
  };
  if (field.empty()) refuse("the field is empty, a number is needed");
  const char* begin = field.data() + (field.front() == '+' && field.size() > 1 ? 1 : 0);
  const char* end = field.data() + field.size();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range)
    refuse(in_quotes(field) + " is beyond what a double can hold");
  if (error != std::errc() || stop != end) refuse(in_quotes(field) + " is no number");
  return value;
}

bool CsvReader::read_line(std::string& line) {
  if (!std::getline(input_, line)) return false;
  ++lines_read_;
  if (lines_read_ == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
  return true;
}

bool CsvReader::read_record() {
  std::string text;
  do {
    if (!read_line(text)) return false;
  } while (trim(text).empty());
  line_ = lines_read_;
  // A quoted field may hold line ends: as long as a quote is open, the record goes on.
  const auto has_odd_quotes = [](const std::string& line) {
    return std::count(line.begin(), line.end(), '"') % 2 != 0;
  };
  std::string more;
  for (bool open = has_odd_quotes(text); open; open = open != has_odd_quotes(more)) {
    if (!read_line(more)) fail("a quote is not closed");
    text += '\n' + more;
  }
  split(std::move(text));
  return true;
}

void CsvReader::split(std::string text) {
  if (text.ends_with('\r')) text.pop_back();
  fields_.clear();
  std::string_view rest = text;
  while (true) {
    std::string field;
    strip(rest);
    if (rest.starts_with('"')) {
      std::size_t at = 1;
      for (; at < rest.size(); ++at) {
        if (rest[at] != '"') {
          field += rest[at];
        } else if (rest.substr(at + 1).starts_with('"')) {
          field += rest[at++];
        } else {
          break;
        }
      }
      rest.remove_prefix(std::min(at + 1, rest.size()));
      strip(rest);
      if (!rest.empty() && rest.front() != ',')
        fail(fmt::format("field {}: text follows the closing quote", fields_.size() + 1));
    } else {
      const std::string_view bare = trim(rest.substr(0, rest.find(',')));
      if (bare.find('"') != std::string_view::npos)
        fail(
            fmt::format("field {}: a quote inside a field that is not quoted", fields_.size() + 1));
      field = bare;
      rest.remove_prefix(std::min(rest.find(','), rest.size()));
    }
    fields_.push_back(std::move(field));
    if (rest.empty()) return;
    rest.remove_prefix(1);
  }
}

void CsvReader::fail(const std::string& what) const {
  throw CsvError(fmt::format("line {}: {}", line_, what));
}

void CsvLine::separate() {
  if (begun_) text_ += ',';
  begun_ = true;
}

CsvLine& CsvLine::add(std::string_view text) {
  separate();
  if (text.find_first_of(",\"\r\n") == std::string_view::npos && trim(text) == text) {
    text_ += text;
    return *this;
  }
  text_ += '"';
  for (const char c : text) {
    if (c == '"') text_ += '"';
    text_ += c;
  }
  text_ += '"';
  return *this;
}

CsvLine& CsvLine::add(double number) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", number);
  return *this;
}

}  // namespace trocar::cli
