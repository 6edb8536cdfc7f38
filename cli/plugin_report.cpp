// SPDX-License-Identifier: Apache-2.0
#include "cli/plugin_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/text_table.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

std::string text_of_loaded(const LoadedPlugin& plugin) {
  TextTable facts;
  facts.row({"file", plugin.file.string()});
  facts.row({"licence", plugin.licence});
  if (!plugin.components.empty()) facts.row({"components", join(plugin.components, ", ")});
  if (!plugin.services.empty()) facts.row({"services", join(plugin.services, ", ")});
  return fmt::format("{} {}: {}\n{}\n", plugin.name, plugin.version, plugin.doc, facts.text());
}

}  // namespace

std::string plugins_text(const Plugins& plugins, const std::vector<PluginFolder>& searched) {
  std::string text;
  for (const LoadedPlugin& plugin : plugins.loaded) text += text_of_loaded(plugin);
  if (plugins.loaded.empty()) text += "No plugin is loaded.\n\n";
  for (const RefusedPlugin& plugin : plugins.refused) {
    text += fmt::format("refused: {}\n", plugin.file.string());
    for (const std::string& reason : plugin.reasons) text += wrapped(reason, 2);
    text += '\n';
  }
  text += "Searched, in this order:\n";
  for (const PluginFolder& folder : searched)
    text += fmt::format("  {}{}\n", folder.path.string(),
                        folder.asked_for ? " (TROCAR_PLUGIN_PATH)" : "");
  return text;
}

nlohmann::ordered_json plugins_json(const Plugins& plugins,
                                    const std::vector<PluginFolder>& searched) {
  auto loaded = nlohmann::ordered_json::array();
  for (const LoadedPlugin& plugin : plugins.loaded)
    loaded.push_back({{"name", plugin.name},
                      {"version", plugin.version},
                      {"licence", plugin.licence},
                      {"doc", plugin.doc},
                      {"file", plugin.file.string()},
                      {"components", plugin.components},
                      {"services", plugin.services}});
  auto refused = nlohmann::ordered_json::array();
  for (const RefusedPlugin& plugin : plugins.refused)
    refused.push_back({{"file", plugin.file.string()}, {"reasons", plugin.reasons}});
  auto folders = nlohmann::ordered_json::array();
  for (const PluginFolder& folder : searched) folders.push_back(folder.path.string());
  return {{"plugins", loaded}, {"refused", refused}, {"searched", folders}};
}

std::vector<std::string> plugin_names(const Plugins& plugins) {
  std::vector<std::string> names;
  for (const LoadedPlugin& plugin : plugins.loaded) names.push_back(plugin.name);
  return names;
}

}  // namespace trocar::cli
