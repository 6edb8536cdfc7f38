// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "cli/spec_results.hpp"

namespace trocar::cli {
namespace {

/// For an attribute or an element. Characters that XML has no way to write are dropped.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\n':
      case '\t':
        result += c;
        break;
      default:
        if (static_cast<unsigned char>(c) >= ' ') result += c;
    }
  }
  return result;
}

std::string headline(const SpecFailure& failure) {
  return !failure.message.empty()
             ? failure.message
             : fmt::format("expected {}, got {}", failure.expected, failure.got);
}

std::string test_case(const SpecResult& result) {
  std::string text = fmt::format(
      "    <testcase name=\"{}\" classname=\"{}\" file=\"{}\" line=\"{}\" time=\"{:.3f}\"",
      escaped(result.test.name), escaped(result.file), escaped(result.test.where.file),
      result.test.where.line, result.seconds);
  if (result.passed() && result.output.empty()) return text + "/>\n";
  text += ">\n";
  for (const SpecFailure& failure : result.failures)
    text += fmt::format("      <failure message=\"{}\">{}</failure>\n", escaped(headline(failure)),
                        escaped(failure.text()));
  if (!result.output.empty())
    text += fmt::format("      <system-out>{}</system-out>\n", escaped(result.output));
  return text + "    </testcase>\n";
}

struct Counts {
  std::size_t tests = 0, failures = 0;
  double seconds = 0.0;

  void take(const SpecResult& result) {
    ++tests;
    failures += result.passed() ? 0 : 1;
    seconds += result.seconds;
  }
  std::string attributes() const {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" time=\"{:.3f}\"", tests, failures,
                       seconds);
  }
};

}  // namespace

std::string junit_xml(const std::vector<SpecResult>& results) {
  Counts all;
  std::string suites;
  for (std::size_t i = 0; i < results.size();) {
    Counts counts;
    std::string cases;
    const std::string& file = results[i].file;
    for (; i < results.size() && results[i].file == file; ++i) {
      counts.take(results[i]);
      all.take(results[i]);
      cases += test_case(results[i]);
    }
    suites += fmt::format("  <testsuite name=\"{}\" {}>\n{}  </testsuite>\n", escaped(file),
                          counts.attributes(), cases);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"trocar test\" {}>\n"
      "{}</testsuites>\n",
      all.attributes(), suites);
}

}  // namespace trocar::cli
