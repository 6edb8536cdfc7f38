// SPDX-License-Identifier: Apache-2.0
#include "cli/command_tree.hpp"

#include "framework/text.hpp"

namespace trocar::cli {
namespace {

using Argument = CommandTree::Argument;

/// The parser describes a check by a set as "{a,b}", behind the name of the type.
void set_values(const std::string& type, Argument& argument) {
  using Values = CommandTree::Values;
  const std::size_t begin = type.find('{'), end = type.rfind('}');
  argument.values = Values::any;
  if (begin != std::string::npos && end != std::string::npos) {
    argument.values = Values::choices;
    const std::string_view set = std::string_view(type).substr(begin + 1, end - begin - 1);
    for (const std::string_view choice : split(set, ',')) argument.choices.emplace_back(choice);
  } else if (type == "FILE" || type.starts_with("FILE.")) {
    argument.values = Values::files;
    argument.suffix = type.substr(std::string_view("FILE").size());
  } else if (type == "COMPONENT") {
    argument.values = Values::components;
  }
}

Argument argument_of(const CLI::Option& option) {
  Argument argument{.label = option.get_name(true), .doc = option.get_description()};
  for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
  argument.repeatable = option.get_items_expected_max() > 1;
  if (option.get_items_expected_max() == 0) return argument;
  if (!argument.names.empty()) argument.label = option.get_type_name();
  argument.may_stand_alone = option.get_items_expected_min() == 0;
  set_values(option.get_type_name(), argument);
  return argument;
}

}  // namespace

CommandTree command_tree(const CLI::App& app) {
  CommandTree tree{.name = app.get_name(), .doc = app.get_description()};
  for (const CLI::Option* option : app.get_options())
    (option->nonpositional() ? tree.options : tree.operands).push_back(argument_of(*option));
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    tree.commands.push_back(command_tree(*command));
  return tree;
}

}  // namespace trocar::cli
