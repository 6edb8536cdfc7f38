// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <optional>

#include "framework/component_definition.hpp"

namespace trocar::hid {

/// One table of a layout, taken entry by entry. What is wrong is noted with its place, and read as
/// if it were not there.
class LayoutTable {
 public:
  LayoutTable(const Literal& value, std::vector<std::string> path,
              std::vector<DefinitionMistake>& mistakes);

  /// Notes each entry that is none of these.
  void refuse_others(const std::vector<std::string>& known) const;
  bool has(std::string_view name) const { return find(name) != nullptr; }
  std::optional<double> number(std::string_view name) const;
  std::optional<int> whole(std::string_view name) const;
  std::optional<bool> flag(std::string_view name) const;
  std::optional<std::string> text(std::string_view name) const;
  /// One text, or a list of them. Empty where there is none.
  std::vector<std::string> texts(std::string_view name) const;
  /// A table in it. @return an empty one where there is none
  LayoutTable table(std::string_view name) const;
  std::vector<std::string> names() const;

  void mistake(std::string message) const;
  /// Of one entry: its name leads to its line.
  void mistake(std::string_view name, std::string message) const;

 private:
  const Literal* find(std::string_view name) const;
  void needs(std::string_view name, std::string_view what) const;

  const Literal::Table* entries_;
  std::vector<std::string> path_;
  std::vector<DefinitionMistake>& mistakes_;
};

}  // namespace trocar::hid
