// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/command_tree.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

using Argument = CommandTree::Argument;
using Values = CommandTree::Values;

/// A text inside of single quotes, with a backslash before each of `special`.
std::string escaped(std::string_view text, std::string_view special) {
  std::string result;
  for (const char c : text) {
    if (c == '\'')
      result += "'\\''";
    else if (special.find(c) != std::string_view::npos)
      result += std::string("\\") + c;
    else
      result += c;
  }
  return result;
}

/// ":label:action" as _arguments reads it.
std::string action(const Argument& argument) {
  const std::string label = escaped(argument.label, ":\\");
  switch (argument.values) {
    case Values::none:
      return "";
    case Values::any:
      return fmt::format(":{}: ", label);
    case Values::choices:
      return fmt::format(":value:({})", join(argument.choices, " "));
    case Values::components:
      return ":component:__trocar_components";
    case Values::files:
      return argument.suffix.empty() ? ":file:_files"
                                     : fmt::format(":file:_files -g \"*{}\"", argument.suffix);
  }
  return "";
}

std::string zsh_option(const Argument& option, const std::string& name) {
  const std::string others = option.repeatable ? "*" : fmt::format("({})", join(option.names, " "));
  const std::string optional = option.may_stand_alone ? ":" : "";
  return fmt::format("    '{}{}{}[{}]{}{}' \\\n", others, name,
                     option.values != Values::none && name.starts_with("--") ? "=" : "",
                     escaped(option.doc, "[]:\\"), optional, action(option));
}

std::string function_name(const std::string& path) {
  std::string name = "_" + path;
  for (char& c : name)
    if (c == ' ') c = '_';
  return name;
}

/// One function for each command, those below it first.
std::string functions(const CommandTree& tree, const std::string& path) {
  std::string text, branches, names;
  for (const CommandTree& command : tree.commands) {
    const std::string below = path + " " + command.name;
    text += functions(command, below);
    branches += fmt::format("      {}) {} ;;\n", command.name, function_name(below));
    names += fmt::format("      '{}:{}'\n", command.name, escaped(command.doc, ":"));
  }
  std::string lines;
  for (const Argument& option : tree.options)
    for (const std::string& name : option.names) lines += zsh_option(option, name);
  for (const Argument& operand : tree.operands)
    lines += fmt::format("    '{}' \\\n", action(operand));
  if (tree.commands.empty())
    return text + fmt::format("{}() {{\n  _arguments -s \\\n{}    && return\n}}\n\n",
                              function_name(path), lines);
  return text +
         fmt::format(
             "{}() {{\n"
             "  local curcontext=$curcontext state line program=${{program:-${{(Q)words[1]}}}}\n"
             "  local -A opt_args\n"
             "  local -a commands=(\n{}  )\n"
             "  _arguments -C \\\n{}"
             "    '1:command:->command' '*::argument:->argument' && return\n"
             "  case $state in\n"
             "    command) _describe command commands ;;\n"
             "    argument) case $line[1] in\n{}"
             "    esac ;;\n"
             "  esac\n"
             "}}\n\n",
             function_name(path), names, lines, branches);
}

}  // namespace

std::string zsh_completion(const CommandTree& tree) {
  return "#compdef trocar\n"
         "# Completes trocar in zsh. Made by: trocar completion zsh\n\n"
         "__trocar_components() {\n"
         "  local -a names=(${(f)\"$($program list --names 2>/dev/null)\"})\n"
         "  _describe component names\n"
         "}\n\n" +
         functions(tree, tree.name) +
         "# Read as a function of fpath, or sourced.\n"
         "if [[ $zsh_eval_context[-1] == loadautofunc ]]; then\n"
         "  _trocar \"$@\"\n"
         "else\n"
         "  compdef _trocar trocar\n"
         "fi\n";
}

}  // namespace trocar::cli
