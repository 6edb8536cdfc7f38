// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/layout_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/text.hpp"

namespace trocar::hid {
namespace {

constexpr double largest_whole = 1e6;

const Literal nothing{Literal::Table{}};

}  // namespace

LayoutTable::LayoutTable(const Literal& value, std::vector<std::string> path,
                         std::vector<DefinitionMistake>& mistakes)
    : entries_(value.as<Literal::Table>()), path_(std::move(path)), mistakes_(mistakes) {
  if (entries_ != nullptr) return;
  entries_ = nothing.as<Literal::Table>();
  const auto* list = value.as<Literal::List>();
  if (list == nullptr || !list->empty())  // {} is both
    mistake(fmt::format("{}: needs a table whose entries have names", value.text()));
}

const Literal* LayoutTable::find(std::string_view name) const {
  for (const Literal::Entry& entry : *entries_)
    if (entry.key == name) return &entry.value;
  return nullptr;
}

void LayoutTable::mistake(std::string message) const {
  mistakes_.push_back({path_, std::move(message)});
}

void LayoutTable::mistake(std::string_view name, std::string message) const {
  std::vector<std::string> path = path_;
  path.emplace_back(name);
  mistakes_.push_back({std::move(path), std::move(message)});
}

void LayoutTable::needs(std::string_view name, std::string_view what) const {
  mistake(name, fmt::format("{}: needs {}", find(name)->text(), what));
}

void LayoutTable::refuse_others(const std::vector<std::string>& known) const {
  for (const Literal::Entry& entry : *entries_)
    if (std::find(known.begin(), known.end(), entry.key) == known.end())
      mistake(entry.key, fmt::format("there is no such entry{}", suggestion(entry.key, known)));
}

std::optional<double> LayoutTable::number(std::string_view name) const {
  const Literal* value = find(name);
  if (value == nullptr) return std::nullopt;
  if (const auto* number = value->as<double>()) return *number;
  needs(name, "a number");
  return std::nullopt;
}

std::optional<int> LayoutTable::whole(std::string_view name) const {
  const Literal* value = find(name);
  if (value == nullptr) return std::nullopt;
  const auto* number = value->as<double>();
  if (number != nullptr && std::abs(*number) <= largest_whole && *number == std::floor(*number))
    return static_cast<int>(*number);
  needs(name, "a whole number");
  return std::nullopt;
}

std::optional<bool> LayoutTable::flag(std::string_view name) const {
  const Literal* value = find(name);
  if (value == nullptr) return std::nullopt;
  if (const auto* flag = value->as<bool>()) return *flag;
  needs(name, "true or false");
  return std::nullopt;
}

std::optional<std::string> LayoutTable::text(std::string_view name) const {
  const Literal* value = find(name);
  if (value == nullptr) return std::nullopt;
  if (const auto* text = value->as<std::string>()) return *text;
  needs(name, "a text");
  return std::nullopt;
}

std::vector<std::string> LayoutTable::texts(std::string_view name) const {
  const Literal* value = find(name);
  std::vector<std::string> texts;
  if (value == nullptr) return texts;
  if (const auto* one = value->as<std::string>()) return {*one};
  const auto* list = value->as<Literal::List>();
  const bool all = list != nullptr && std::all_of(list->begin(), list->end(), [](const Literal& l) {
                     return l.as<std::string>() != nullptr;
                   });
  if (all)
    for (const Literal& each : *list) texts.push_back(*each.as<std::string>());
  else
    needs(name, "a text, or a list of texts");
  return texts;
}

LayoutTable LayoutTable::table(std::string_view name) const {
  std::vector<std::string> path = path_;
  path.emplace_back(name);
  const Literal* value = find(name);
  return {value != nullptr ? *value : nothing, std::move(path), mistakes_};
}

std::vector<std::string> LayoutTable::names() const {
  std::vector<std::string> names;
  for (const Literal::Entry& entry : *entries_) names.push_back(entry.key);
  return names;
}

}  // namespace trocar::hid
