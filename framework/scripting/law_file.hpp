// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "framework/finding.hpp"
#include "framework/port.hpp"
#include "framework/scripting/declared_parameters.hpp"

namespace trocar::lua {

/// A port that a law declares: "m", "Vector3 [N] in device", "Joints [m, m, m]",
/// "Jacobian of 6 axes", "Enumeration" with labels; or such a text in a table with doc, optional
/// and labels.
struct LawPort {
  std::string name;
  const TypeInfo* type = nullptr;
  std::string unit{};     // as it was written
  std::string si_unit{};  // what numbers are in inside the law: "m", "N, N m"
  std::string frame{};
  int axes = 0;
  std::string doc{};
  bool optional = false;
  std::vector<std::string> labels{};

  PortOptions options() const;
  /// Of Joints they are counted by their units.
  int axes_of() const;
};

/// What kind of component a law's file makes.
enum class LawKind { fixture, component };

/// A file with a law that runs inside the loop, as it declares itself.
struct LawFile {
  LawKind kind = LawKind::fixture;
  std::string name;  // as errors call it: "membrane.lua"
  std::string path;  // as findings do
  std::string text;
  int step_line = 0;  // where its step function begins
  std::vector<DeclaredParameter> parameters{};
  std::vector<LawPort> inputs{};   // a fixture's position and velocity included
  std::vector<LawPort> outputs{};  // a fixture's force included

  /// The line that says `entry = …` behind the one that says `section = …`; the best guess where
  /// nothing does.
  int line_of(std::string_view section, std::string_view entry = "") const;
};

/// Runs the file in a world of the loop's kind and reads what it returns.
/// @return null, and findings with the lines, where it is wrong
std::shared_ptr<const LawFile> read_law(LawKind kind, const std::string& name,
                                        const std::string& path, std::string text,
                                        Findings& findings);

}  // namespace trocar::lua
