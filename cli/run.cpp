// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

#include "cli/available.hpp"
#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/intervention.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/script_options.hpp"
#include "cli/serving.hpp"
#include "cli/timing_options.hpp"
#include "framework/report.hpp"
#include "framework/scripting/script.hpp"

namespace trocar::cli {
namespace {

constexpr double default_simulated_duration = 10.0;  // [s]: virtual time would never end by itself

struct RunArguments {
  ScriptOptions script;
  WaitOptions wait;
  OverloadOptions overload;
  std::string duration;
  std::string clock = "realtime";
  std::optional<std::string> record;
  std::string black_box;
  std::string json;
  bool console = false;
  bool watch = false;
  Serving serving;
};

/// A file that cannot be written is found before the run, and one that was there stays whole.
void check_writable(const std::string& path) {
  const bool was_there = std::filesystem::exists(path);
  const bool writable = std::ofstream(path, std::ios::binary | std::ios::app).good();
  if (!was_there) std::remove(path.c_str());
  if (!writable)
    throw CLI::ValidationError("--json", fmt::format("{} cannot be written", in_quotes(path)));
}

SessionOptions session_options(const RunArguments& arguments) {
  SessionOptions options;
  for (const ClockKind kind : {ClockKind::realtime, ClockKind::simulated, ClockKind::device})
    if (arguments.clock == to_string(kind)) options.clock = kind;
  if (!arguments.duration.empty()) options.duration = duration_of(arguments.duration, "--for");
  options.seed = arguments.script.seed;
  if (arguments.record) options.record = arguments.record;
  arguments.wait.apply(options.timing);
  arguments.overload.apply(options.timing);
  if (arguments.black_box != "off") options.black_box = BlackBoxOptions{};
  if (options.black_box && !arguments.black_box.empty())
    options.black_box->file = arguments.black_box;
  options.print_to_stderr = arguments.json == "-";
  return options;
}

int run(RunArguments& arguments) {
  if (!arguments.json.empty() && arguments.json != "-") check_writable(arguments.json);
  const bool simulated = arguments.clock == to_string(ClockKind::simulated);
  if (arguments.console && simulated)
    throw CLI::ValidationError("--console", "needs --clock realtime: nobody types in virtual time");
  if (arguments.watch && simulated)
    throw CLI::ValidationError("--watch",
                               "needs --clock realtime; `reloads` of trocar.run does the "
                               "same in virtual time");
  const Registry registry = available_components();
  SessionOptions options = session_options(arguments);
  Graph::Overrides script_arguments;
  arguments.script.split(options.set, script_arguments);
  Progress progress;
  if (isatty(STDERR_FILENO) != 0 && !arguments.console) options.watch = &progress;
  options.default_duration = default_simulated_duration;
  options.stop = &stop_on_interrupt();
  std::optional<Intervention> intervention;
  if (options.clock != ClockKind::simulated)
    intervention.emplace(arguments.console, arguments.watch).add_to(options);
  arguments.serving.start(registry, options);
  Session session(registry, options);
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
  command
      ->add_option("--clock", arguments->clock,
                   "realtime; simulated: as fast as it goes; device: by its reports")
      ->check(CLI::IsMember({"realtime", "simulated", "device"}));
  arguments->wait.add_to(*command);
  arguments->overload.add_to(*command);
  command->add_option("--record", arguments->record, "Write an MCAP log to this file")
      ->check(check_file_name)
      ->type_name("FILE.mcap");
  command
      ->add_option("--json", arguments->json, "Write the report as JSON to this file, - for stdout")
      ->check(check_file_name)
      ->type_name("FILE");
  command
      ->add_option("--black-box", arguments->black_box,
                   "Where the last 5 s before a fault are written, or off (default: beside the "
                   "log or after the script, NAME.blackbox-1.mcap)")
      ->type_name("FILE.mcap|off");
  command->add_flag("--watch", arguments->watch,
                    "Reload laws (LuaFixture, LuaComponent) whose files are saved");
  arguments->serving.add_to(*command);
  command->add_flag("--console", arguments->console,
                    "Type while it runs: names of signals and parameters, wall.stiffness = 3 N/mm, "
                    "help");
  command->footer(
      "Example:\n"
      "  trocar run scripts/tutorial/01_feel_a_wall.lua --for 5s --clock simulated\n"
      "Ctrl-C ends a run in order, with its report. On a terminal, in real time, space stops the\n"
      "rendering, a acknowledges a fault, h homes a device, e engages, q ends the run.\n"
      "Spin, latency and overload are about real time alone; docs/realtime.md has the "
      "definitions.\n"
      "Exit status: 0 success, 1 a fault or a loss, 2 wrong usage or a broken script.");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace trocar::cli
