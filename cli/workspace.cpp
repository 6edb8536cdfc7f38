// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/progress_bar.hpp"
#include "cli/script_options.hpp"
#include "cli/workspace_options.hpp"
#include "cli/workspace_report.hpp"

namespace trocar::cli {
namespace {

struct WorkspaceAnswer {
  WorkspaceOptions device;
  std::string csv;
  std::string json;
};

WorkspaceReport sampled(const WorkspaceOptions& options) {
  ProgressBar bar("sampling the workspace");
  return workspace_report(
      options.settings(),
      {.threads = options.threads(),
       .progress = [&](std::size_t done, std::size_t count) { bar.show(done, count); }});
}

int show_workspace(const WorkspaceAnswer& options) {
  if (options.csv == "-" && options.json == "-")
    throw CLI::ValidationError("--csv", "only one of --csv and --json can go to standard output");
  // Before the time is spent.
  for (const std::string* path : {&options.csv, &options.json})
    if (!path->empty()) write_output(*path, "");
  WorkspaceReport report;
  try {
    report = sampled(options.device);
  } catch (const std::invalid_argument& error) {
    complain("workspace: " + WorkspaceOptions::explain(error.what()));
    return misused;
  }
  if (report.sampled.poses.empty()) {
    complain("workspace: no pose inside all limits was found: widen a limit, or try more --poses");
    return failed;
  }
  if (options.csv != "-" && options.json != "-") print(workspace_text(report));
  if (!options.csv.empty()) write_output(options.csv, workspace_csv(report));
  if (!options.json.empty())
    write_output(options.json, workspace_json(report, options.device.parameters()).dump(2) + '\n');
  return success;
}

}  // namespace

void add_workspace(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "workspace", "Where the laparoscope's tool reaches, and how well it moves and pushes there");
  const auto options = std::make_shared<WorkspaceAnswer>();
  command
      ->add_option("--csv", options->csv, "Write the map cell by cell to this file, - for stdout")
      ->type_name("FILE")
      ->check(check_file_name);
  command
      ->add_option("--json", options->json, "Write everything as JSON to this file, - for stdout")
      ->type_name("FILE")
      ->check(check_file_name);
  options->device.add_to(*command);
  command->footer(
      "Tips and poses are Sobol points under random shifts; the spread over the shifts is the\n"
      "standard error. Forces are those at the tip in the worst direction. Quantities are written\n"
      "as in scripts; files are in SI.\n\n"
      "Example:\n  trocar workspace --tool-length \"160 mm\" --tilt \"40 deg\" --csv map.csv");
  command->callback([options, &status] { status = show_workspace(*options); });
}

}  // namespace trocar::cli
