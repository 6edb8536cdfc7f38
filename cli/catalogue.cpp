// SPDX-License-Identifier: Apache-2.0
#include "cli/catalogue.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/text_table.hpp"

namespace trocar::cli {
namespace {

bool is_group(const ComponentType& type) {
  return !type.make;
}

/// Its line, with what a reader may want to know besides.
std::string line_of(const ComponentType& type) {
  std::string line = type.doc;
  if (is_group(type)) line += " (group)";
  if (!type.plugin.empty()) line += " (plugin " + type.plugin + ")";
  return line;
}

}  // namespace

std::vector<std::string> categories_of(const Registry& registry) {
  std::vector<std::string> categories;
  for (const ComponentType& type : registry.types())
    if (std::find(categories.begin(), categories.end(), type.category) == categories.end())
      categories.push_back(type.category);
  return categories;
}

std::string catalogue_text(const Registry& registry) {
  if (registry.types().empty()) return "No components are registered.\n";
  std::size_t widest = 0;  // so that the columns of all categories are aligned
  for (const ComponentType& type : registry.types())
    widest = std::max(widest, display_width(type.name));
  std::string text;
  for (const std::string& category : categories_of(registry)) {
    TextTable lines;
    for (const ComponentType& type : registry.types())
      if (type.category == category)
        lines.row({type.name + std::string(widest - display_width(type.name), ' '), line_of(type)});
    text += category + '\n' + lines.text() + '\n';
  }
  return text + "One of them in full: trocar describe " + registry.types().front().name + "\n";
}

nlohmann::ordered_json catalogue_json(const Registry& registry) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ComponentType& type : registry.types())
    list.push_back(
        {{"name", type.name},
         {"category", type.category},
         {"doc", type.doc},
         {"group", is_group(type)},
         {"plugin", type.plugin.empty() ? nullptr : nlohmann::ordered_json(type.plugin)}});
  return {{"components", list}};
}

}  // namespace trocar::cli
