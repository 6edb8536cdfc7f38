// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
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
  std::string black_box;
  std::string json;
};

SessionOptions session_options(const RunArguments& arguments) {
  SessionOptions options;
  options.clock = arguments.clock == "simulated" ? ClockKind::simulated : ClockKind::realtime;
  if (!arguments.duration.empty()) options.duration = duration_of(arguments.duration, "--for");
  options.seed = arguments.script.seed;
  if (!arguments.record.empty()) options.record = arguments.record;
  if (arguments.black_box != "off") options.black_box = BlackBoxOptions{};
  if (options.black_box && !arguments.black_box.empty())
    options.black_box->file = arguments.black_box;
  options.stop = &interrupted;
  options.print_to_stderr = arguments.json == "-";
  return options;
}

/// To a file, or to standard output for "-".
void write_json(const std::string& path, const std::string& text) {
  if (path == "-") return print(text);
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.flush();
  if (!file) throw std::runtime_error(fmt::format("cannot write the report \"{}\"", path));
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
    complain(fmt::format("{} {}:\n{}", broken.findings.all().size(),
                         broken.findings.all().size() == 1 ? "mistake" : "mistakes",
                         broken.findings.text()));
    status = misused;
  }
  session.finish();
  if (status == success && !session.sound()) status = failed;
  if (arguments.json != "-" && !session.runs().empty()) print(report_text(session));
  if (!arguments.json.empty()) write_json(arguments.json, report_json(session));
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
  command->add_option("--record", arguments->record, "Write an MCAP log to this file");
  command->add_option("--black-box", arguments->black_box,
                      "Where the last 5 s before a fault are written, or off (default: beside the "
                      "log or after the script, NAME.blackbox-1.mcap)");
  command->add_option("--json", arguments->json,
                      "Write the report as JSON to this file, - for stdout");
  command->footer(
      "Example:\n"
      "  trocar run scripts/tutorial/01_feel_a_wall.lua --for 5s --clock simulated\n"
      "Ctrl-C ends a run in order, with its report.\n"
      "Exit status: 0 success, 1 a fault or a loss, 2 wrong usage or a broken script.");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace trocar::cli
