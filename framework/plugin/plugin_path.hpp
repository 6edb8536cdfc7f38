// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace trocar {

/// A folder that is searched for plugins.
struct PluginFolder {
  std::filesystem::path path;
  bool asked_for = true;  // by the user, who is told when it is not there
};

/// Where plugins are looked for, in this order: the folders of `variable`, which is a list with
/// colons (that of TROCAR_PLUGIN_PATH), then trocar/plugins beside the framework's own library, be
/// it in a build or installed, and wherever that was moved to.
std::vector<PluginFolder> plugin_folders(std::string_view variable);

/// The same by the environment.
std::vector<PluginFolder> plugin_folders();

/// The plugins of a folder, each a file NAME.so, in the order of their names.
/// @throw std::runtime_error when it cannot be read
std::vector<std::filesystem::path> plugin_files(const std::filesystem::path& folder);

}  // namespace trocar
