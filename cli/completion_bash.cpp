// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/command_tree.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

using Argument = CommandTree::Argument;
using Values = CommandTree::Values;

std::string words(const std::vector<std::string>& list) {
  return fmt::format("_trocar_words '{}'", join(list, " "));
}

/// The shell's words that offer the values, or "" where nobody knows them.
std::string offer(const Argument& argument) {
  switch (argument.values) {
    case Values::choices:
      return words(argument.choices);
    case Values::files:
      return fmt::format("_trocar_files '*{}'", argument.suffix);
    case Values::components:
      return "_trocar_words \"$(\"$program\" list --names 2>/dev/null)\"";
    case Values::none:
    case Values::any:
      return ":";
  }
  return ":";
}

/// The tables of a command and of those below it, as branches of `case`. Keys are the commands that
/// were given, joined by blanks, and what follows them.
struct Tables {
  std::string commands;  // "kinematics fk") where a word is a command
  std::string takes;     // "run --clock") where an option waits for its value
  std::string values;    // what to offer for it
  std::string operands;  // "check 0") what to offer for the n-th operand
  std::string options;   // "check")

  void add(const CommandTree& tree, const std::string& path) {
    const std::string before = path.empty() ? "" : path + " ";
    std::vector<std::string> names, flags;
    for (const CommandTree& command : tree.commands) {
      names.push_back(command.name);
      commands += fmt::format("      '{0}{1}') path='{0}{1}' ;;\n", before, command.name);
      add(command, before + command.name);
    }
    for (const Argument& option : tree.options)
      for (const std::string& name : option.names) {
        flags.push_back(name);
        if (option.values == Values::none || option.may_stand_alone) continue;
        takes += fmt::format("      '{}{}') option=$at ;;\n", before, name);
        values += fmt::format("      '{}{}') {} ;;\n", before, name, offer(option));
      }
    if (!names.empty()) operands += fmt::format("      '{}0') {} ;;\n", before, words(names));
    for (std::size_t i = 0; i < tree.operands.size(); ++i)
      operands += fmt::format("      '{}{}') {} ;;\n", before, i, offer(tree.operands[i]));
    options += fmt::format("    '{}') {} ;;\n", path, words(flags));
  }
};

constexpr std::string_view head = R"(# Completes trocar in bash. Made by: trocar completion bash

_trocar_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word")
}

# Folders, and the files that the pattern means.
_trocar_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$word"; compgen -f -X "!$1" -- "$word" |
    while IFS= read -r file; do [ -d "$file" ] || printf '%s\n' "$file"; done)
}

_trocar() {
  local program=$1 word=${COMP_WORDS[COMP_CWORD]} path='' option='' given=0 i at
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; ++i)); do
    at=${COMP_WORDS[i]}
    [ "$at" = = ] && continue # of --option=value, which bash takes for three words
    if [ -n "$option" ]; then
      option=''
      continue
    fi
    case "${path:+$path }$at" in
)";

}  // namespace

std::string bash_completion(const CommandTree& tree) {
  Tables tables;
  tables.add(tree, "");
  std::string text(head);
  text += tables.commands + tables.takes;
  text +=
      "      *) [[ $at == -* ]] || given=$((given + 1)) ;;\n"
      "    esac\n"
      "  done\n"
      "  [ \"$word\" = = ] && word=''\n"
      "  if [ -n \"$option\" ]; then\n"
      "    case \"${path:+$path }$option\" in\n" +
      tables.values +
      "    esac\n"
      "    return\n"
      "  fi\n"
      "  if [[ $word != -* ]]; then\n"
      "    case \"${path:+$path }$given\" in\n" +
      tables.operands +
      "    esac\n"
      "  fi\n"
      "  # What begins with a hyphen, or follows the last operand, is an option.\n"
      "  [ ${#COMPREPLY[@]} = 0 ] || return\n"
      "  [[ $word == -* || -z $word ]] || return\n"
      "  case \"$path\" in\n" +
      tables.options +
      "  esac\n"
      "}\n\n"
      "complete -F _trocar trocar\n";
  return text;
}

}  // namespace trocar::cli
