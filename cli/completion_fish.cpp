// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/command_tree.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

using Argument = CommandTree::Argument;
using Values = CommandTree::Values;

std::string shell_quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

/// What follows as `complete` reads it: -x takes no file for it, -F any.
std::string fish_offer(const Argument& argument) {
  switch (argument.values) {
    case Values::choices:
      return " -x -a " + shell_quoted(join(argument.choices, " "));
    case Values::components:
      return " -x -a '(__trocar_components)'";
    case Values::files:
      return argument.suffix.empty()
                 ? " -r -F"
                 : fmt::format(" -x -k -a '(__fish_complete_suffix {})'", argument.suffix);
    case Values::any:
      return " -x";
    case Values::none:
      return "";
  }
  return "";
}

std::string fish_option(const Argument& option, const std::string& condition) {
  std::string line = "complete -c trocar -n " + shell_quoted(condition);
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.values != Values::none && !option.may_stand_alone) line += fish_offer(option);
  return line + " -d " + shell_quoted(option.doc) + "\n";
}

std::string lines(const CommandTree& tree, const std::string& path) {
  const std::string condition = fmt::format("__trocar_at{}", path.empty() ? "" : " " + path);
  std::string text;
  for (const CommandTree& command : tree.commands)
    text += fmt::format("complete -c trocar -n {} -a {} -d {}\n", shell_quoted(condition),
                        command.name, shell_quoted(command.doc));
  for (const Argument& option : tree.options) text += fish_option(option, condition);
  for (const Argument& operand : tree.operands)
    text +=
        fmt::format("complete -c trocar -n {}{}\n", shell_quoted(condition), fish_offer(operand));
  for (const CommandTree& command : tree.commands)
    text += lines(command, path.empty() ? command.name : path + " " + command.name);
  return text;
}

/// A branch for each command, below others or not: what was given so far.
std::string branches(const CommandTree& tree, const std::string& path) {
  std::string text;
  for (const CommandTree& command : tree.commands) {
    const std::string below = path.empty() ? command.name : path + " " + command.name;
    text += fmt::format("      case {}\n        set path {}\n", shell_quoted(below), below);
    text += branches(command, below);
  }
  return text;
}

}  // namespace

std::string fish_completion(const CommandTree& tree) {
  return "# Completes trocar in fish. Made by: trocar completion fish\n\n"
         "# Whether exactly these commands were given so far.\n"
         "function __trocar_at\n"
         "  set -l path\n"
         "  for word in (commandline -opc)[2..-1]\n"
         "    switch (string join ' ' -- $path $word)\n" +
         branches(tree, "") +
         "    end\n"
         "  end\n"
         "  test \"$path\" = \"$argv\"\n"
         "end\n\n"
         "function __trocar_components\n"
         "  set -l words (commandline -opc)\n"
         "  $words[1] list --names 2>/dev/null\n"
         "end\n\n"
         "complete -c trocar -f\n" +
         lines(tree, "");
}

}  // namespace trocar::cli
