// SPDX-License-Identifier: Apache-2.0
// A plugin that says nothing of itself.
#include "framework/plugin/plugin.hpp"

const trocar::Plugin* trocar_plugin() {
  static constexpr trocar::Plugin plugin{.name = "bare", .doc = nullptr};
  return &plugin;
}
