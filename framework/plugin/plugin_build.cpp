// SPDX-License-Identifier: Apache-2.0
#include "framework/plugin/plugin_build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

namespace trocar {
namespace {

// It is read as bytes of a file.
static_assert(std::is_trivially_copyable_v<PluginBuild>);
static_assert(sizeof(PluginBuild) == 2 * 16 + 4 * (1 + 3 + 1 + 1 + 3 + 2 + 8));

std::string version_text(const PluginBuild::Version& version) {
  return fmt::format("{}.{}.{}", version[0], version[1], version[2]);
}

std::string compiler_text(const PluginBuild& build) {
  const auto end = std::find(build.compiler.begin(), build.compiler.end(), '\0');
  return fmt::format("{} {}", std::string(build.compiler.begin(), end), build.compiler_major);
}

std::string standard_text(const PluginBuild& build) {
  return fmt::format("C++ {}", build.standard);  // as __cplusplus: 202002
}

std::string alignment_text(const PluginBuild& build) {
  return fmt::format("Eigen aligned to {} and {} bytes", build.alignment, build.static_alignment);
}

std::string interface_text(const PluginBuild& build) {
  return fmt::format(" (plugin interface {})", build.interface);
}

bool same_minor_version(const PluginBuild& a, const PluginBuild& b) {
  return std::equal(a.trocar.begin(), a.trocar.begin() + 2, b.trocar.begin());
}

/// What is on in one of two builds, and must be in both or in none.
struct Switch {
  std::int32_t PluginBuild::*member;
  const char* name;
  const char* on;  // how to switch it on, and off
  const char* off;
};

constexpr Switch build_switches[] = {
    {&PluginBuild::row_major, "matrices by rows (EIGEN_DEFAULT_TO_ROW_MAJOR)",
     "define EIGEN_DEFAULT_TO_ROW_MAJOR", "leave out EIGEN_DEFAULT_TO_ROW_MAJOR"},
    {&PluginBuild::libcpp, "libc++", "compile with -stdlib=libc++", "leave out -stdlib=libc++"},
    {&PluginBuild::old_strings, "the strings of before C++11 (_GLIBCXX_USE_CXX11_ABI=0)",
     "define _GLIBCXX_USE_CXX11_ABI=0", "leave out _GLIBCXX_USE_CXX11_ABI=0"},
    {&PluginBuild::checked_containers, "containers that check (_GLIBCXX_DEBUG)",
     "define _GLIBCXX_DEBUG", "leave out _GLIBCXX_DEBUG, _GLIBCXX_ASSERTIONS will do"},
    {&PluginBuild::type_information, "type information", "leave out -fno-rtti",
     "compile with -fno-rtti"},
    {&PluginBuild::exceptions, "exceptions", "leave out -fno-exceptions",
     "compile with -fno-exceptions"},
    {&PluginBuild::address_sanitizer, "AddressSanitizer", "compile with -fsanitize=address",
     "leave out -fsanitize=address"},
    {&PluginBuild::thread_sanitizer, "ThreadSanitizer", "compile with -fsanitize=thread",
     "leave out -fsanitize=thread"},
};

}  // namespace

const PluginBuild& framework_build() {
  static constexpr PluginBuild build;
  return build;
}

std::vector<std::string> differences(const PluginBuild& plugin, const PluginBuild& framework) {
  std::vector<std::string> found;
  const bool same_interface = plugin.interface == framework.interface;
  if (!same_minor_version(plugin, framework) || !same_interface)
    found.push_back(fmt::format(
        "built with Trocar {}{}, this is {}{}: rebuild it with find_package(Trocar {}.{})",
        version_text(plugin.trocar), same_interface ? "" : interface_text(plugin),
        version_text(framework.trocar), same_interface ? "" : interface_text(framework),
        framework.trocar[0], framework.trocar[1]));
  if (!same_interface) return found;

  const auto add = [&](const std::string& has, const std::string& wanted, const std::string& cure) {
    if (has != wanted)
      found.push_back(fmt::format("built with {}, Trocar with {}: {}", has, wanted, cure));
  };
  add(compiler_text(plugin), compiler_text(framework),
      "rebuild it with that compiler, by -DCMAKE_CXX_COMPILER=…");
  add(standard_text(plugin), standard_text(framework),
      "rebuild it with that one, by CXX_STANDARD of CMake");
  add("Eigen " + version_text(plugin.eigen), "Eigen " + version_text(framework.eigen),
      "rebuild it with that one, by -DEigen3_DIR=…");
  add(alignment_text(plugin), alignment_text(framework),
      fmt::format("leave out -march=, -mavx and Eigen's definitions, or add "
                  "-DEIGEN_MAX_ALIGN_BYTES={}",
                  framework.alignment));
  for (const Switch& each : build_switches) {
    const bool has = plugin.*each.member != 0, wanted = framework.*each.member != 0;
    if (has != wanted)
      found.push_back(fmt::format("built {} {}, Trocar {}: {}", has ? "with" : "without", each.name,
                                  wanted ? "with" : "without", wanted ? each.on : each.off));
  }
  return found;
}

}  // namespace trocar
