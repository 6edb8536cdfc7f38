// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "framework/recording/ros2_schema.hpp"

namespace trocar {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Cuts the first word off `text`.
std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(blanks), text.size());
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

class Parser {
 public:
  Parser(std::string_view name, std::string_view text) : rest_(text) {
    messages_.push_back({ros2_short_name(name), {}, {}});
  }

  std::vector<Ros2Message> parse() {
    while (!rest_.empty()) line(next_line());
    check_ros2_messages(messages_);
    return std::move(messages_);
  }

 private:
  [[noreturn]] void refuse(const std::string& text) const {
    throw std::invalid_argument("ros2msg: line " + std::to_string(number_) + ": " + text);
  }

  std::string_view next_line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return trimmed(line);
  }

  void line(std::string_view text) {
    if (text.size() >= 3 && text.find_first_not_of('=') == std::string_view::npos)
      return separator();
    const std::size_t hash = std::min(text.find('#'), text.size());
    std::string_view comment = text.substr(std::min(hash + 1, text.size()));
    const std::string_view code = trimmed(text.substr(0, hash));
    comment = trimmed(comment);
    Ros2Message& message = messages_.back();
    if (!code.empty()) return field(code, comment);
    if (message.fields.empty() && message.comment.empty()) message.comment = comment;
  }

  void separator() {
    const std::string_view text = next_line();
    if (!text.starts_with("MSG:")) refuse("'MSG: package/Name' should follow the line of '='");
    messages_.push_back({ros2_short_name(trimmed(text.substr(4))), {}, {}});
  }

  void field(std::string_view code, std::string_view comment) {
    std::string_view rest = code;
    const std::string_view type = take_word(rest);
    const std::string_view name = take_word(rest);
    if (name.empty()) refuse("'" + std::string(code) + "' should be a type and a name");
    if (name.find('=') != std::string_view::npos || rest.starts_with('=')) return;  // a constant
    const std::size_t bracket = std::min(type.find('['), type.size());
    Ros2Field field;
    field.name = name;
    field.type = type_name(type.substr(0, bracket));
    field.array_length = array_length(type.substr(bracket));
    field.comment = comment;
    messages_.back().fields.push_back(field);
  }

  std::string type_name(std::string_view type) const {
    if (find_ros2_type(type) != nullptr) return std::string(type);
    if (type.find('/') != std::string_view::npos) return ros2_short_name(type);
    const std::string& owner = messages_.back().name;  // the same package is meant
    return owner.substr(0, owner.find('/') + 1) + std::string(type);
  }

  std::uint32_t array_length(std::string_view brackets) const {
    if (brackets.empty()) return 0;
    std::uint32_t length = 0;
    const char* end = brackets.data() + brackets.size();
    const auto [stop, error] = std::from_chars(brackets.data() + 1, end, length);
    if (error != std::errc() || stop + 1 != end || *stop != ']' || length == 0)
      refuse("'" + std::string(brackets) + "' should be a fixed length, e.g. '[3]'");
    return length;
  }

  std::string_view rest_;
  int number_ = 0;
  std::vector<Ros2Message> messages_;
};

}  // namespace

std::vector<Ros2Message> parse_ros2_schema(std::string_view name, std::string_view text) {
  return Parser(name, text).parse();
}

}  // namespace trocar
