// SPDX-License-Identifier: Apache-2.0
#include "framework/plugin/plugin_file.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace trocar {

PluginBuild build_in_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) throw std::runtime_error("there is no such file");
  if (!std::filesystem::is_regular_file(file, ignored))
    throw std::runtime_error("it is no file, but a folder or a device");
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw std::runtime_error("it cannot be read: look at its rights");
  if (!bytes.starts_with("\x7f"
                         "ELF"))
    throw std::runtime_error("it is no shared library: build one with trocar_plugin() of CMake");

  const PluginBuild::Text& mark = framework_build().mark;
  const std::size_t at = bytes.find(std::string_view(mark.data(), mark.size()));
  if (at == std::string::npos || bytes.size() - at < sizeof(PluginBuild))
    throw std::runtime_error(
        "it is a library, but no plugin of Trocar: it needs trocar_plugin() of "
        "framework/plugin/plugin.hpp, and in it a static constexpr trocar::Plugin");
  PluginBuild build;
  std::memcpy(&build, bytes.data() + at, sizeof build);
  return build;
}

}  // namespace trocar
