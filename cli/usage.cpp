// SPDX-License-Identifier: Apache-2.0
#include "cli/usage.hpp"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "framework/text.hpp"
#include "framework/version.hpp"

namespace trocar::cli {
namespace {

/// The command that the arguments reached.
const CLI::App& deepest(const CLI::App& app) {
  const std::vector<CLI::App*> reached = app.get_subcommands();
  return reached.empty() ? app : deepest(*reached.back());
}

std::vector<std::string> subcommands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string full_name(const CLI::App& app) {
  const CLI::App* parent = app.get_parent();
  return parent == nullptr ? app.get_name() : full_name(*parent) + " " + app.get_name();
}

/// What was not understood, e.g. "--jsn"; "" when the mistake is another.
std::string stranger(const CLI::App& app) {
  const std::vector<std::string> left = app.remaining(true);
  return left.empty() ? "" : left.front();
}

std::string explain(const CLI::App& command, const std::string& word,
                    const CLI::ParseError& error) {
  const std::vector<std::string> commands = subcommands_of(command);
  if (word.starts_with("-")) {
    const std::string name = word.substr(0, word.find('='));
    return fmt::format("there is no option {}{}", in_quotes(name),
                       suggestion(name, options_of(command)));
  }
  if (!word.empty() && !commands.empty())
    return fmt::format("there is no command {}{}", in_quotes(word), suggestion(word, commands));
  if (!word.empty()) return fmt::format("{} is one argument too many", in_quotes(word));
  if (!commands.empty() && command.get_subcommands().empty())
    return "a command is needed: " + join(commands, ", ");
  return error.what();
}

}  // namespace

void set_up(CLI::App& app) {
  app.set_version_flag("--version", "trocar " + version(), "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.get_formatter()->column_width(28);
  app.require_subcommand(1);
  app.footer("Each command explains itself: trocar COMMAND --help");
}

int report(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = deepest(app);
  if (dynamic_cast<const CLI::CallForHelp*>(&error) != nullptr) {
    print(app.help());
    return success;
  }
  if (dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr) {
    print(std::string(error.what()) + "\n");
    return success;
  }
  const std::string name = full_name(command);
  const std::string place = command.get_parent() == nullptr ? "" : name.substr(7) + ": ";
  complain(place + explain(command, stranger(app), error));
  complain(fmt::format("see {} --help", name));
  return misused;
}

}  // namespace trocar::cli
