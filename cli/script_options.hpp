// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "framework/session.hpp"

namespace trocar::cli {

/// What `run`, `check` and `graph` have in common: the script, --set and --seed.
struct ScriptOptions {
  std::string script;
  std::vector<std::string> settings;  // of --set, "key=value"
  std::optional<std::uint64_t> seed;

  void add_to(CLI::App& command);
  /// Keys with a dot are parameters, the others entries of trocar.args.
  /// @throw CLI::ValidationError when one has no equals sign
  void split(Graph::Overrides& parameters, Graph::Overrides& arguments) const;
};

/// --seed, a whole number.
void add_seed_option(CLI::App& command, std::optional<std::uint64_t>& seed);

/// A check for options that take a file's name: what is wrong, or "".
std::string check_file_name(const std::string& text);

/// "2 mistakes:" and a line for each.
std::string mistakes_text(const Findings& findings);

/// "5s", "200 ms" and "1.5 min" in seconds.
/// @throw CLI::ValidationError with what is allowed
double duration_of(const std::string& text, const std::string& option);

}  // namespace trocar::cli
