// SPDX-License-Identifier: Apache-2.0
#include "cli/spec_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/available.hpp"
#include "cli/output.hpp"
#include "cli/process_pool.hpp"

namespace trocar::cli {
namespace {

using nlohmann::json;

constexpr std::string_view spec_ending = "_spec.lua";

// What goes from a test's process to ours. Texts of scripts may be no UTF-8: they are mended.
std::string dump(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

json to_json(const Where& where) {
  return {{"file", where.file}, {"line", where.line}};
}

Where where_from(const json& value) {
  return {value.at("file").get<std::string>(), value.at("line").get<int>()};
}

json to_json(const SpecFailure& failure) {
  return {{"where", to_json(failure.where)},
          {"message", failure.message},
          {"expected", failure.expected},
          {"got", failure.got},
          {"tick", failure.tick},
          {"plot", failure.plot}};
}

SpecFailure failure_from(const json& value) {
  return {.where = where_from(value.at("where")),
          .message = value.at("message").get<std::string>(),
          .expected = value.at("expected").get<std::string>(),
          .got = value.at("got").get<std::string>(),
          .tick = value.at("tick").get<std::int64_t>(),
          .plot = value.at("plot").get<std::string>()};
}

json to_json(const Findings& findings) {
  json list = json::array();
  for (const Finding& finding : findings.all())
    list.push_back({{"where", to_json(finding.where)}, {"message", finding.message}});
  return list;
}

/// In a process of its own.
std::string list_one(const std::string& file) {
  json answer = {{"tests", json::array()}, {"findings", json::array()}};
  try {
    for (const SpecTest& test : list_spec(available().registry, file))
      answer["tests"].push_back({{"name", test.name}, {"where", to_json(test.where)}});
  } catch (const BrokenGraph& broken) {
    answer["findings"] = to_json(broken.findings);
  } catch (const std::exception& error) {
    Findings findings;
    findings.add({file, 0}, error.what());
    answer["findings"] = to_json(findings);
  }
  return dump(answer);
}

/// In a process of its own.
std::string run_one(const SpecResult& test, const SpecOptions& options) {
  json answer = json::array();
  try {
    for (const SpecFailure& failure :
         run_spec(available().registry, test.file, test.index, options))
      answer.push_back(to_json(failure));
  } catch (const std::exception& error) {
    answer.push_back(to_json(SpecFailure{.where = test.test.where, .message = error.what()}));
  }
  return dump(answer);
}

}  // namespace

std::vector<std::string> find_specs(const std::vector<std::string>& paths) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (fs::is_regular_file(path)) {
      files.push_back(path);
    } else if (fs::is_directory(path)) {
      std::vector<std::string> found;
      for (const auto& entry : fs::recursive_directory_iterator(path))
        if (entry.is_regular_file() && entry.path().string().ends_with(spec_ending))
          found.push_back(entry.path().lexically_normal().string());
      if (found.empty())
        throw std::invalid_argument(
            fmt::format("{} has no file whose name ends with {}", in_quotes(path), spec_ending));
      std::sort(found.begin(), found.end());
      files.insert(files.end(), found.begin(), found.end());
    } else {
      throw std::invalid_argument(fmt::format("there is no file or folder {}", in_quotes(path)));
    }
  }
  std::set<std::string> seen;
  std::erase_if(files, [&](const std::string& file) {
    return !seen.insert(fs::weakly_canonical(file).string()).second;
  });
  return files;
}

std::vector<SpecResult> list_specs(const std::vector<std::string>& files,
                                   const SpecRunOptions& options, Findings& broken) {
  std::vector<ProcessOutcome> outcomes(files.size());
  run_in_processes(
      files.size(), {.at_once = options.at_once, .timeout = options.timeout},
      [&](std::size_t i) { return list_one(files[i]); },
      [&](std::size_t i, ProcessOutcome outcome) { outcomes[i] = std::move(outcome); });
  std::vector<SpecResult> tests;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!outcomes[i].trouble.empty()) {
      broken.add({files[i], 0}, "reading it " + outcomes[i].trouble);
      continue;
    }
    const json answer = json::parse(outcomes[i].answer);
    for (const json& finding : answer.at("findings"))
      broken.add(where_from(finding.at("where")), finding.at("message").get<std::string>());
    std::size_t index = 0;
    for (const json& test : answer.at("tests"))
      tests.push_back({.file = files[i],
                       .test = {test.at("name").get<std::string>(), where_from(test.at("where"))},
                       .index = index++});
  }
  return tests;
}

void run_specs(std::vector<SpecResult>& tests, const SpecRunOptions& options,
               const std::function<void(const SpecResult&)>& told) {
  std::vector<bool> ended(tests.size(), false);
  std::size_t next = 0;  // to be told
  run_in_processes(
      tests.size(), {.at_once = options.at_once, .timeout = options.timeout},
      [&](std::size_t i) { return run_one(tests[i], options.spec); },
      [&](std::size_t i, ProcessOutcome outcome) {
        SpecResult& test = tests[i];
        test.seconds = outcome.seconds;
        test.output = std::move(outcome.output);
        if (outcome.trouble.empty())
          for (const json& failure : json::parse(outcome.answer))
            test.failures.push_back(failure_from(failure));
        else
          test.failures.push_back(
              {.where = test.test.where, .message = "the test " + outcome.trouble});
        ended[i] = true;
        for (; next < tests.size() && ended[next]; ++next) told(tests[next]);
      });
}

}  // namespace trocar::cli
