// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/entry_lines.hpp"

#include <cctype>

#include "framework/text.hpp"

namespace trocar::lua {
namespace {

bool is_entry_at(std::string_view line, std::size_t at, std::string_view name) {
  const auto letter = [&](std::size_t i) {
    return i < line.size() && (std::isalnum(static_cast<unsigned char>(line[i])) || line[i] == '_');
  };
  if ((at > 0 && letter(at - 1)) || letter(at + name.size())) return false;
  const std::size_t next = line.find_first_not_of(" \t", at + name.size());
  return next != std::string_view::npos && line[next] == '=';
}

/// Where the entry begins, or npos.
std::size_t find_entry(std::string_view line, std::string_view name, std::size_t from) {
  for (std::size_t at = line.find(name, from); at != std::string_view::npos;
       at = line.find(name, at + 1))
    if (is_entry_at(line, at, name)) return at;
  return std::string_view::npos;
}

}  // namespace

int line_of_entry(std::string_view text, std::span<const std::string> path) {
  int line = 0, found = 1;
  for (const std::string_view each : split(text, '\n')) {
    ++line;
    std::size_t from = 0;
    while (!path.empty()) {
      const std::size_t at = find_entry(each, path.front(), from);
      if (at == std::string_view::npos) break;
      found = line;
      from = at + path.front().size();
      path = path.subspan(1);
    }
    if (path.empty()) break;
  }
  return found;
}

}  // namespace trocar::lua
