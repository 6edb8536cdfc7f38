// SPDX-License-Identifier: Apache-2.0
#include "tests/kernel/transcript.hpp"

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace trocar::test {
namespace {

/// The first word, which is taken away from the text with the space after it.
std::string take_word(std::string& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string word = text.substr(0, end);
  text.erase(0, end + 1);
  return word;
}

}  // namespace

nlohmann::json Transcript::json(const std::string& name) const {
  const auto file = files.find(name);
  return nlohmann::json::parse(file == files.end() ? "" : file->second, nullptr, false);
}

Transcript transcript_of(std::string_view text) {
  Transcript all;
  std::istringstream lines{std::string(text)};
  std::string* file = nullptr;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] != '@') {
      if (file != nullptr) *file += line + "\n";
      continue;
    }
    std::string rest = line.substr(1);
    const std::string what = take_word(rest);
    if (what == "begin") {
      file = &(all.files[rest] = "");
    } else if (what == "end") {
      file = nullptr;
    } else if (what == "state") {
      const std::string name = take_word(rest);
      all.states[name] = rest;
    } else if (what == "asked") {
      const std::string name = take_word(rest);
      all.asked[name] = std::strtod(rest.c_str(), nullptr);
    } else if (what == "kernel") {
      all.kernel = rest;
    } else if (what == "rate") {
      all.rate = std::strtod(rest.c_str(), nullptr);
    } else if (what.starts_with("failed")) {
      all.failures.push_back(rest);
    } else if (what == "done") {
      all.complete = true;
    }
  }
  return all;
}

EffortZero effort_zero(const std::string& state) {
  const std::size_t begin = state.find("effort zero ");
  EffortZero zero;
  if (begin == std::string::npos) return zero;
  zero.said = std::sscanf(state.c_str() + begin,
                          "effort zero %lf ms after the last good report and %lf ms after",
                          &zero.after_report, &zero.after_command) == 2;
  return zero;
}

}  // namespace trocar::test
