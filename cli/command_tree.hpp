// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace trocar::cli {

/// A command with all that may follow it, read from the parser: what completion scripts are made
/// from. The name of an option's type tells what its values are:
///
///   FILE      any file             COMPONENT   what `trocar list` lists
///   FILE.lua  a file that ends so  {a,b}       one of these
struct CommandTree {
  enum class Values { none, any, choices, files, components };
  struct Argument {
    std::vector<std::string> names{};  // "-o", "--output"; none for an operand
    std::string label{};               // of an operand, or of the option's values: "script", "FILE"
    std::string doc{};
    Values values = Values::none;
    std::vector<std::string> choices{};
    std::string suffix{};          // of files: ".lua"; "" for any
    bool may_stand_alone = false;  // an option that needs no value
    bool repeatable = false;
  };

  std::string name{};
  std::string doc{};
  std::vector<Argument> options{};
  std::vector<Argument> operands{};
  std::vector<CommandTree> commands{};
};

CommandTree command_tree(const CLI::App& app);

// The scripts that make a shell complete the command.
std::string bash_completion(const CommandTree& tree);
std::string zsh_completion(const CommandTree& tree);
std::string fish_completion(const CommandTree& tree);

}  // namespace trocar::cli
