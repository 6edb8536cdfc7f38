// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/plugin/plugin_build.hpp"
#include "framework/registry.hpp"

namespace trocar {

/// What a plugin says of itself, and how what it brings gets into a registry.
struct Plugin {
  PluginBuild build{};       // left as it is: the plugin's compiler fills it
  const char* name = "";     // that of its file: "example" of example.so
  const char* version = "";  // its own: "1.0.0"
  const char* licence = "";  // by SPDX: "Apache-2.0"
  const char* doc = "";      // one line
  /// Adds its components, devices and services to an empty registry. All of them get into the one
  /// that scripts use, or, where it throws or a name is taken, none.
  void (*register_with)(Registry&) = nullptr;
};

}  // namespace trocar

/// The one function that a plugin exports. The object that it returns must be `static constexpr`:
/// the loader reads its `build` in the file.
///
///   const trocar::Plugin* trocar_plugin() {
///     static constexpr trocar::Plugin plugin{.name = "example", …, .register_with = add_all};
///     return &plugin;
///   }
extern "C" [[gnu::visibility("default")]] const trocar::Plugin* trocar_plugin();
