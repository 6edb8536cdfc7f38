// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/plugin/plugin_path.hpp"
#include "framework/registry.hpp"

namespace trocar {

/// A plugin whose types are in a registry.
struct LoadedPlugin {
  std::string name;
  std::string version;
  std::string licence;
  std::string doc;
  std::filesystem::path file;
  std::vector<std::string> components;  // names, devices and groups among them
  std::vector<std::string> services;
};

struct RefusedPlugin {
  std::filesystem::path file;        // or a folder that cannot be searched
  std::vector<std::string> reasons;  // each with its cure
};

struct Plugins {
  std::vector<LoadedPlugin> loaded;
  std::vector<RefusedPlugin> refused;
};

/// Loads the plugins of all folders, and adds what they bring to `registry`. One that is refused
/// hinders no other. Of two files of one name, that of the earlier folder is taken.
///
/// A plugin is never unloaded: nobody knows who still has an object of it.
Plugins load_plugins(Registry& registry, const std::vector<PluginFolder>& folders);

}  // namespace trocar
