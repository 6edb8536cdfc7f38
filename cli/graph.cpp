// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "cli/available.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/script_options.hpp"
#include "framework/graph_dot.hpp"
#include "framework/graph_json.hpp"
#include "framework/graph_mermaid.hpp"
#include "framework/scripting/script.hpp"

namespace trocar::cli {
namespace {

struct GraphOptions {
  ScriptOptions script;
  std::string format = "dot";
  std::string file = "-";
};

std::string graph_text(const Graph& graph, const WiredGraph& wired, const std::string& format) {
  if (format == "json") return graph_json(graph, &wired) + '\n';
  const GraphPicture picture = picture_of(graph, wired);
  return format == "mermaid" ? graph_mermaid(picture) : graph_dot(picture);
}

int draw(const GraphOptions& options) {
  const Registry registry = available_components();
  SessionOptions session_options{.seed = options.script.seed, .check_only = true};
  session_options.print_to_stderr = true;
  Graph::Overrides script_arguments;
  options.script.split(session_options.set, script_arguments);
  Session session(registry, session_options);
  std::string text;
  try {
    run_script(session, options.script.script, std::move(script_arguments));
    const std::unique_ptr<WiredGraph> wired = wire(session.graph(), session.first_wiring());
    text = graph_text(session.graph(), *wired, options.format);
  } catch (const BrokenGraph& broken) {
    complain(mistakes_text(broken.findings));
    return misused;
  }
  write_output(options.file, text);
  return success;
}

}  // namespace

void add_graph(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("graph", "Draw a script's graph without running it");
  const auto options = std::make_shared<GraphOptions>();
  options->script.add_to(*command);
  command->add_option("--format", options->format, "dot (Graphviz), mermaid, or json for programs")
      ->check(CLI::IsMember({"dot", "json", "mermaid"}));
  command->add_option("-o,--output", options->file, "Write to this file, - for stdout")
      ->type_name("FILE");
  command->footer(
      "Example:\n"
      "  trocar graph scripts/tutorial/01_feel_a_wall.lua | dot -Tsvg > graph.svg\n"
      "Dotted arrows are inputs that are used a tick later.\n"
      "A script that runs its graph itself is read up to its first trocar.run.");
  command->callback([options, &status] { status = draw(*options); });
}

}  // namespace trocar::cli
