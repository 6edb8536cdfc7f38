// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/available.hpp"
#include "cli/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/plugin_report.hpp"
#include "cli/reference.hpp"
#include "components/register.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

struct ListOptions {
  std::string what = "components";
  bool json = false;
  bool names = false;
  bool markdown = false;
};

void print_names(const std::vector<std::string>& names) {
  if (!names.empty()) print(join(names, "\n") + "\n");
}

void list_plugins(const ListOptions& options) {
  if (options.markdown) throw CLI::ValidationError("--markdown", "is for components; take --json");
  const Plugins plugins = available().plugins;
  if (options.json)
    print_json(plugins_json(plugins, plugin_folders()));
  else if (options.names)
    print_names(plugin_names(plugins));
  else
    print(plugins_text(plugins, plugin_folders()));
}

void list_components(const ListOptions& options) {
  if (options.markdown) {
    Registry built_in;
    register_components(built_in);
    print(reference_markdown(built_in));
    return;
  }
  const Registry registry = available_components();
  if (options.json)
    print_json(catalogue_json(registry));
  else if (options.names)
    print_names(registry.names());
  else
    print(catalogue_text(registry));
}

}  // namespace

void add_list(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("list", "List the components that a script can use");
  const auto options = std::make_shared<ListOptions>();
  command->add_option("WHAT", options->what, "components (the default), or plugins")
      ->check(CLI::IsMember({"components", "plugins"}));
  CLI::Option* as_json = command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--names", options->names, "Print the names alone, one a line")
      ->excludes(as_json);
  command
      ->add_flag("--markdown", options->markdown,
                 "Print all that are built in, in full, as docs/components.md")
      ->excludes(as_json)
      ->excludes("--names");
  command->footer(
      "Example:\n  trocar list\n  trocar list plugins\n"
      "Plugins are files NAME.so in the folders of TROCAR_PLUGIN_PATH, a list with colons, and\n"
      "in trocar/plugins beside the library. docs/plugins.md says how to make one.");
  command->callback([options, &status] {
    if (options->what == "plugins")
      list_plugins(*options);
    else
      list_components(*options);
    status = success;
  });
}

}  // namespace trocar::cli
