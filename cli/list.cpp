// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/reference.hpp"
#include "components/register.hpp"
#include "framework/text.hpp"

namespace trocar::cli {

void add_list(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("list", "List the components that a script can use");
  const auto json = std::make_shared<bool>(false);
  const auto names = std::make_shared<bool>(false);
  const auto markdown = std::make_shared<bool>(false);
  CLI::Option* as_json = command->add_flag("--json", *json, "Print JSON");
  command->add_flag("--names", *names, "Print the names alone, one a line")->excludes(as_json);
  command->add_flag("--markdown", *markdown, "Print all of them in full, as docs/components.md")
      ->excludes(as_json)
      ->excludes("--names");
  command->footer("Example:\n  trocar list");
  command->callback([json, names, markdown, &status] {
    Registry registry;
    register_components(registry);
    if (*json)
      print_json(catalogue_json(registry));
    else if (*markdown)
      print(reference_markdown(registry));
    else if (*names)
      print(join(registry.names(), "\n") + "\n");
    else
      print(catalogue_text(registry));
    status = success;
  });
}

}  // namespace trocar::cli
