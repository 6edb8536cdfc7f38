// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <csignal>
#include <memory>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/script_options.hpp"
#include "components/register.hpp"
#include "framework/report.hpp"
#include "framework/scripting/script.hpp"

namespace trocar::cli {
namespace {

constexpr double default_simulated_duration = 10.0;  // [s]: virtual time would never end by itself

StopFlag interrupted;

/// The first Ctrl-C ends the run in order; a second one kills.
void interrupt(int) {
  interrupted.raise();
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

struct RunArguments {
  ScriptOptions script;
  std::string duration;
  std::string clock = "realtime";
  std::string record;
  std::string json;
};

SessionOptions session_options(const RunArguments& arguments) {
  SessionOptions options;
  options.clock = arguments.clock == "simulated" ? ClockKind::simulated : ClockKind::realtime;
  if (!arguments.duration.empty()) options.duration = duration_of(arguments.duration, "--for");
  options.seed = arguments.script.seed;
  if (!arguments.record.empty()) options.record = arguments.record;
  options.stop = &interrupted;
  options.print_to_stderr = arguments.json == "-";
  return options;
}

int run(const RunArguments& arguments) {
  Registry registry;
  register_components(registry);
  SessionOptions options = session_options(arguments);
  Graph::Overrides script_arguments;
  arguments.script.split(options.set, script_arguments);
  Progress progress;
  if (isatty(STDERR_FILENO) != 0) options.progress = &progress;
  options.default_duration = default_simulated_duration;
  Session session(registry, options);
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  int status = success;
  try {
    run_script(session, arguments.script.script, std::move(script_arguments));
  } catch (const BrokenGraph& broken) {
    session.finish();
    complain(mistakes_text(broken.findings));
    status = misused;
  }
  session.finish();
  if (status == success && !session.sound()) status = failed;
  if (arguments.json != "-" && !session.runs().empty()) print(report_text(session));
  if (!arguments.json.empty()) write_output(arguments.json, report_json(session));
  return status;
}

}  // namespace

void add_run(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("run", "Run a script");
  const auto arguments = std::make_shared<RunArguments>();
  arguments->script.add_to(*command);
  command->add_option("--for", arguments->duration,
                      "How long, e.g. 5s (default: until Ctrl-C; 10 s in simulated time)");
  command->add_option("--clock", arguments->clock, "realtime, or simulated: as fast as it goes")
      ->check(CLI::IsMember({"realtime", "simulated"}));
  command->add_option("--record", arguments->record, "Write an MCAP log to this file")
      ->type_name("FILE.mcap");
  command
      ->add_option("--json", arguments->json, "Write the report as JSON to this file, - for stdout")
      ->type_name("FILE");
  command->footer(
      "Example:\n"
      "  trocar run scripts/tutorial/01_feel_a_wall.lua --for 5s --clock simulated\n"
      "Ctrl-C ends a run in order, with its report.\n"
      "Exit status: 0 success, 1 a fault or a loss, 2 wrong usage or a broken script.");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace trocar::cli
