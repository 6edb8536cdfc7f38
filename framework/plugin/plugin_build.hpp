// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "framework/abi.hpp"
#include "framework/version.hpp"

namespace trocar {

/// What a compilation was made with, as far as it decides whether its objects fit those of another.
/// A plugin holds one that its own compiler filled, and the framework holds one of its own.
///
/// The loader finds it in the plugin's file by `mark`, before anything of the plugin runs: code of
/// another layout must not run to say that it does not fit.
struct PluginBuild {
  using Text = std::array<char, 16>;
  using Version = std::array<std::int32_t, 3>;

  // These stay where they are in every version of Trocar, so that each can name any other.
  Text mark = {'\x7f', 'T', 'r', 'o', 'c', 'a', 'r', ' ', 'p', 'l', 'u', 'g', 'i', 'n', '\x1a'};
  std::int32_t interface = 1;  // number of this layout and of that of Plugin
  Version trocar = {TROCAR_VERSION_MAJOR, TROCAR_VERSION_MINOR, TROCAR_VERSION_PATCH};

  // These have a meaning where `interface` is the same.
#ifdef __clang__
  Text compiler = {'C', 'l', 'a', 'n', 'g'};
  std::int32_t compiler_major = __clang_major__;
#else
  Text compiler = {'G', 'N', 'U'};
  std::int32_t compiler_major = __GNUC__;
#endif
  std::int32_t standard = __cplusplus;
  Version eigen = {EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION};
  std::int32_t alignment = EIGEN_MAX_ALIGN_BYTES;                // [B]
  std::int32_t static_alignment = EIGEN_MAX_STATIC_ALIGN_BYTES;  // [B]

  // Switches, 0 or 1.
#ifdef EIGEN_DEFAULT_TO_ROW_MAJOR
  std::int32_t row_major = 1;
#else
  std::int32_t row_major = 0;
#endif
#ifdef _LIBCPP_VERSION
  std::int32_t libcpp = 1;
#else
  std::int32_t libcpp = 0;
#endif
#if defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
  std::int32_t old_strings = 1;
#else
  std::int32_t old_strings = 0;
#endif
#ifdef _GLIBCXX_DEBUG
  std::int32_t checked_containers = 1;
#else
  std::int32_t checked_containers = 0;
#endif
#ifdef __cpp_rtti
  std::int32_t type_information = 1;
#else
  std::int32_t type_information = 0;
#endif
#ifdef __cpp_exceptions
  std::int32_t exceptions = 1;
#else
  std::int32_t exceptions = 0;
#endif
  // Clang tells by __has_feature, which other preprocessors cannot even read.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TROCAR_PLUGIN_ADDRESS_SANITIZER
#endif
#if __has_feature(thread_sanitizer)
#define TROCAR_PLUGIN_THREAD_SANITIZER
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(TROCAR_PLUGIN_ADDRESS_SANITIZER)
  std::int32_t address_sanitizer = 1;
#else
  std::int32_t address_sanitizer = 0;
#endif
#if defined(__SANITIZE_THREAD__) || defined(TROCAR_PLUGIN_THREAD_SANITIZER)
  std::int32_t thread_sanitizer = 1;
#else
  std::int32_t thread_sanitizer = 0;
#endif
};

/// What the framework itself was made with.
const PluginBuild& framework_build();

/// Everything in which `plugin` does not fit `framework`, each a line with the cure: "built with
/// Trocar 0.1.0, this is 0.2.0: rebuild it with find_package(Trocar 0.2)". A newer patch is no
/// difference: it changes no interface.
std::vector<std::string> differences(const PluginBuild& plugin, const PluginBuild& framework);

}  // namespace trocar
