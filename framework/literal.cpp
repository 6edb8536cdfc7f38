// SPDX-License-Identifier: Apache-2.0
#include "framework/literal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "framework/text.hpp"

namespace trocar {
namespace {

struct LiteralText {
  std::string operator()(std::monostate) const { return "nil"; }
  std::string operator()(bool b) const { return b ? "true" : "false"; }
  std::string operator()(double d) const { return fmt::format("{:.12g}", d); }
  std::string operator()(const std::string& s) const { return "\"" + s + "\""; }
  std::string operator()(const Literal::List& list) const {
    std::vector<std::string> parts;
    for (const Literal& part : list) parts.push_back(part.text());
    return "{" + join(parts, ", ") + "}";
  }
  std::string operator()(const Literal::Table& table) const {
    std::vector<std::string> parts;
    for (const auto& [key, part] : table) parts.push_back(key + " = " + part.text());
    return "{" + join(parts, ", ") + "}";
  }
};

bool quoted(std::string_view text) {
  return text.size() >= 2 && text.front() == '"' && text.find('"', 1) == text.size() - 1;
}

Literal scalar_from_text(std::string_view text) {
  if (quoted(text)) return {std::string(text.substr(1, text.size() - 2))};
  if (text == "true") return {true};
  if (text == "false") return {false};
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size()) return {number};
  return {std::string(text)};
}

}  // namespace

std::string Literal::text() const {
  return std::visit(LiteralText{}, value);
}

Literal literal_from_text(std::string_view text) {
  text = trim(text);
  if (quoted(text)) return scalar_from_text(text);
  const bool braced = text.starts_with('{') && text.ends_with('}');
  if (braced) text = trim(text.substr(1, text.size() - 2));
  if (braced && text.empty()) return {Literal::List{}};
  if (text.find('=') != std::string_view::npos) {
    Literal::Table table;
    for (const std::string_view part : split(text, ',')) {
      const std::size_t equals = std::min(part.find('='), part.size());
      const std::string_view after = equals < part.size() ? part.substr(equals + 1) : "";
      table.push_back({std::string(trim(part.substr(0, equals))), scalar_from_text(trim(after))});
    }
    return {table};
  }
  if (!braced && text.find(',') == std::string_view::npos) return scalar_from_text(text);
  Literal::List list;
  for (const std::string_view part : split(text, ',')) list.push_back(scalar_from_text(trim(part)));
  return {list};
}

}  // namespace trocar
