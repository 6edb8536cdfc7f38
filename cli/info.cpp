// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.hpp"
#include "cli/log_report.hpp"
#include "cli/output.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

struct InfoOptions {
  std::string file;
  std::string pattern;
  bool with_values = false;
  bool json = false;

  std::optional<std::string> signals() const {
    return with_values ? std::optional(pattern) : std::nullopt;
  }
};

bool any_matches(const LogSummary& log, const std::string& pattern,
                 std::vector<std::string>& names) {
  for (const LogSummary::Channel& channel : log.channels)
    for (const LogSignal& signal : channel.signal_list) {
      if (matches(pattern, signal.name)) return true;
      names.push_back(signal.name);
    }
  return false;
}

int inform(const InfoOptions& options) {
  std::error_code error;
  if (!std::filesystem::exists(options.file, error)) {
    complain(fmt::format("info: there is no file {}", in_quotes(options.file)));
    return misused;
  }
  const LogSummary log = summarize_log(options.file, options.with_values);
  std::vector<std::string> names;
  if (options.with_values && !options.pattern.empty() &&
      !any_matches(log, options.pattern, names)) {
    const std::string near = nearest(options.pattern, names);
    complain(fmt::format("info: no signal matches {}{}", in_quotes(options.pattern),
                         near.empty() ? "; without --signals, info lists them"
                                      : fmt::format(", did you mean \"{}\"?", near)));
    return misused;
  }
  if (options.json)
    print_json(log_json(log, options.signals()));
  else
    print(log_text(log, options.signals()));
  if (!log.damaged()) return success;
  complain("info: messages do not fit their schema, see the channels");
  return failed;
}

}  // namespace

void add_info(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("info", "Tell what a log holds");
  const auto options = std::make_shared<InfoOptions>();
  command->add_option("LOG", options->file, "Log in MCAP format, from Trocar or anybody else")
      ->required()
      ->type_name("FILE.mcap");
  CLI::Option* signals =
      command->add_option("--signals", options->pattern, "Print the signals' values")
          ->expected(0, 1)
          ->type_name("[PATTERN]");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "--signals prints the first, last, least and greatest value of each signal, or\n"
      "of those that PATTERN means: a part of the name, or all of it with * and ?.\n\n"
      "Example:\n  trocar info demo.mcap --signals 'wall.*'");
  command->callback([options, signals, &status] {
    options->with_values = signals->count() > 0;
    try {
      status = inform(*options);
    } catch (const std::runtime_error& error) {
      complain(std::string("info: ") + error.what());
      status = failed;
    }
  });
}

}  // namespace trocar::cli
