// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace trocar {

/// A value as a script, an option or a file wrote it, before a declaration gives it a meaning:
/// true, 3, "2.2 N/mm", {0, 0, "105 mm"}, {pitch = "20 deg"}.
struct Literal {
  struct Entry;  // not a pair: clang 14 cannot complete one that holds what it stands in
  using List = std::vector<Literal>;
  using Table = std::vector<Entry>;  // in the writer's order

  std::variant<std::monostate, bool, double, std::string, List, Table> value;

  template <typename T>
  const T* as() const {
    return std::get_if<T>(&value);
  }
  /// As the writer would write it in a script.
  std::string text() const;
};

/// A named part of a table.
struct Literal::Entry {
  Entry(std::string_view name, Literal part) : key(name), value(std::move(part)) {}
  std::string key;
  Literal value;
};

/// What an option's text means: true and false, a plain number, a list where there are commas (with
/// or without braces), a table where there are equals signs, else a string. Double quotes keep a
/// string from being read any further: "true", "a,b".
Literal literal_from_text(std::string_view text);

}  // namespace trocar
