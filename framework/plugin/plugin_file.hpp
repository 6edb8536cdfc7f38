// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "framework/plugin/plugin_build.hpp"

namespace trocar {

/// What the plugin in `file` was made with, read without loading it.
/// @throw std::runtime_error when there is no such file, it is no library, or no plugin
PluginBuild build_in_file(const std::filesystem::path& file);

}  // namespace trocar
