// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/available.hpp"
#include "cli/commands.hpp"
#include "cli/description.hpp"
#include "cli/output.hpp"

namespace trocar::cli {
namespace {

struct DescribeOptions {
  std::string name;
  bool json = false;
};

int describe_one(const DescribeOptions& options) {
  const Registry registry = available_components();
  std::optional<Description> description;
  try {
    description = describe(registry, options.name);
  } catch (const std::invalid_argument& error) {
    complain(std::string("describe: ") + error.what());
    return misused;
  }
  if (options.json)
    print_json(description_json(*description));
  else
    print(description_text(*description));
  return success;
}

}  // namespace

void add_describe(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("describe", "Explain a component: its inputs, outputs and parameters");
  const auto options = std::make_shared<DescribeOptions>();
  command->add_option("NAME", options->name, "Component as scripts call it, e.g. Wall")
      ->required()
      ->type_name("COMPONENT");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer("Example:\n  trocar describe Wall");
  command->callback([options, &status] { status = describe_one(*options); });
}

}  // namespace trocar::cli
