// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/available.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/script_options.hpp"
#include "cli/spec_results.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

struct TestArguments {
  std::vector<std::string> paths{"."};
  std::string filter;
  std::size_t jobs = 0;
  std::string timeout = "60 s";
  std::optional<std::uint64_t> seed;
  std::string junit;
  bool list = false;
};

std::string indented(const std::string& text, std::string_view indent) {
  std::string result;
  for (const std::string_view line : split(text, '\n')) {
    if (!line.empty()) result += fmt::format("{}{}", indent, line);
    result += '\n';
  }
  result.erase(result.find_last_not_of('\n') + 1);
  return result + "\n";
}

/// Tells of each test as it ends, under its file's name.
class TestReport {
 public:
  void take(const SpecResult& result) {
    if (result.file != file_) print(result.file + "\n");
    file_ = result.file;
    print(fmt::format("  {}  {}  ({:.2f} s)\n", result.passed() ? "passed" : "FAILED",
                      result.test.name, result.seconds));
    ++(result.passed() ? passed_ : failed_);
    if (result.passed()) return;
    for (const SpecFailure& failure : result.failures) print(indented(failure.text(), "    "));
    if (!result.output.empty()) print("    it printed\n" + indented(result.output, "      "));
  }

  /// @return what the command ends with
  int finish() const {
    print(fmt::format("{} {}: {} passed, {} failed\n", passed_ + failed_,
                      passed_ + failed_ == 1 ? "test" : "tests", passed_, failed_));
    return failed_ == 0 ? success : failed;
  }

 private:
  std::string file_;
  std::size_t passed_ = 0, failed_ = 0;
};

void keep_matching(std::vector<SpecResult>& tests, const std::string& filter) {
  std::vector<std::string> names;
  for (const SpecResult& test : tests) names.push_back(test.test.name);
  std::erase_if(tests, [&](const SpecResult& test) {
    return test.test.name.find(filter) == std::string::npos &&
           test.file.find(filter) == std::string::npos;
  });
  if (tests.empty())
    throw CLI::ValidationError(
        "--filter", fmt::format("no test's name or file contains {}{}", in_quotes(filter),
                                nearest(filter, names).empty() ? "" : suggestion(filter, names)));
}

int test(const TestArguments& arguments) {
  SpecRunOptions options;
  options.spec.seed = arguments.seed;
  options.at_once = arguments.jobs;
  options.timeout = duration_of(arguments.timeout, "--timeout");
  warn_of_refused(available().plugins);  // here once, and not in the process of each test
  Findings broken;
  std::vector<SpecResult> tests;
  try {
    tests = list_specs(find_specs(arguments.paths), options, broken);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("PATH", error.what());
  }
  if (!arguments.filter.empty()) keep_matching(tests, arguments.filter);
  if (arguments.list) {
    for (const SpecResult& each : tests)
      print(fmt::format("{}: {}\n", each.test.where.text(), each.test.name));
  } else if (!tests.empty()) {
    TestReport report;
    run_specs(tests, options, [&](const SpecResult& result) { report.take(result); });
    if (!arguments.junit.empty()) write_output(arguments.junit, junit_xml(tests));
    const int status = report.finish();
    if (broken.empty()) return status;
  }
  if (broken.empty()) return success;
  complain(mistakes_text(broken));
  return misused;
}

}  // namespace

void add_test(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("test", "Test scripts and fixtures by Lua specs");
  const auto arguments = std::make_shared<TestArguments>();
  command->add_option("path", arguments->paths, "Specs, or folders with files named *_spec.lua")
      ->type_name("FILE")
      ->default_str(".");
  command->add_option("--filter", arguments->filter, "Only tests whose name or file contains this");
  command->add_option("--jobs,-j", arguments->jobs, "How many at a time (default: all processors)")
      ->check(CLI::Range(1, 1024));
  command->add_option("--timeout", arguments->timeout, "Of each test, in real time (default 60 s)");
  add_seed_option(*command, arguments->seed);
  command->add_option("--junit", arguments->junit, "Write JUnit's XML to this file, - for stdout")
      ->check(check_file_name)
      ->type_name("FILE");
  command->add_flag("--list", arguments->list, "Print the tests' names and places, run none");
  command->footer(
      "Example:\n  trocar test scripts/fixtures\n"
      "Each test runs in virtual time, in a process of its own. docs/scripting.md says what a\n"
      "spec may expect.\n"
      "Exit status: 0 all passed, 1 some failed, 2 wrong usage or a broken spec.");
  command->callback([arguments, &status] { status = test(*arguments); });
}

}  // namespace trocar::cli
