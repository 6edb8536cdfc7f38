// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cli/description.hpp"

/// @file
/// Definitions for the Lua language server, in its annotations (LuaCATS): what a script may write,
/// for an editor to complete, to explain and to check. Nobody runs them.

namespace trocar::cli {

/// What every file of definitions begins with; only files that do are written over.
constexpr std::string_view stub_header =
    "---@meta _\n-- Written by `trocar stubs`; changes are lost.\n";

/// Names that scripts can be asked for once their graphs are known.
struct ScriptNames {
  struct Name {
    std::string name;  // "wall.force.z", "wall.stiffness"
    std::string doc;   // one line
    bool live = false;
  };
  std::vector<Name> signals{};     // ports, and the numbers in them
  std::vector<Name> parameters{};  // of every component and group
};

/// The class of a component's table, that of what its constructor returns, and the constructor.
std::string component_stub(const Description& description, const Registry& registry);
/// A class for each type that an output can have, with its fields.
std::string output_types_stub();
/// All components, and the threads that make them: components.lua.
std::string components_stub(const Registry& registry);
/// What is the same in all scripts: functions, operators, results: trocar.lua.
std::string_view language_stub();
/// Laws, from outside and inside: laws.lua.
std::string_view laws_stub();
/// What specs say: specs.lua.
std::string_view specs_stub();
/// What completes in `run["…"]`, `set`, `edits` and `keep`: names.lua.
std::string names_stub(const ScriptNames& names);

/// Of scripts as they are described up to their first trocar.run.
/// @throw BrokenGraph with every finding
ScriptNames names_of(const Registry& registry, const std::vector<std::string>& scripts);

/// What became of a file that was to be written.
enum class Written { anew, again, kept };
/// Writes definitions, over older ones alone.
/// @throw std::runtime_error where somebody else's file is, or none can be
Written write_stub(const std::filesystem::path& path, std::string_view text);
/// Writes a file of settings where there is none.
/// @throw std::runtime_error where none can be
Written write_settings(const std::filesystem::path& path, std::string_view text);

}  // namespace trocar::cli
