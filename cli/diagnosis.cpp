// SPDX-License-Identifier: Apache-2.0
#include "cli/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/text_table.hpp"

namespace trocar::cli {

using Level = Diagnosis::Level;

const char* to_string(Level level) {
  switch (level) {
    case Level::good:
      return "good";
    case Level::note:
      return "note";
    case Level::warning:
      return "warning";
    case Level::problem:
      return "problem";
  }
  return "unknown";
}

/// Cures are not wrapped: they are to be copied.
std::string diagnoses_text(std::vector<Diagnosis> diagnoses) {
  const auto count = [&](Level level) {
    return static_cast<std::uint64_t>(std::count_if(
        diagnoses.begin(), diagnoses.end(), [&](const auto& one) { return one.level == level; }));
  };
  std::stable_sort(diagnoses.begin(), diagnoses.end(),
                   [](const Diagnosis& a, const Diagnosis& b) { return a.level > b.level; });
  std::string text =
      fmt::format("{}, {}, {}\n", counted(count(Level::problem), "problem"),
                  counted(count(Level::warning), "warning"), counted(count(Level::note), "note"));
  for (const Diagnosis& one : diagnoses) {
    text += one.level == Level::good ? "" : "\n";
    TextTable table("", 0);
    table.row({fmt::format("{:7}", to_string(one.level)), one.finding});
    text += table.text();
    std::string cure = one.cure;
    for (std::size_t at = 0; (at = cure.find('\n', at)) != std::string::npos; at += 10)
      cure.insert(at + 1, "         ");
    if (!cure.empty()) text += "  cure:  " + cure + "\n";
  }
  return text;
}

nlohmann::ordered_json diagnoses_json(const std::vector<Diagnosis>& diagnoses) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Diagnosis& one : diagnoses)
    list.push_back({{"key", one.key},
                    {"level", to_string(one.level)},
                    {"finding", one.finding},
                    {"cure", one.cure}});
  return {{"sound", sound(diagnoses)}, {"findings", std::move(list)}};
}

bool sound(const std::vector<Diagnosis>& diagnoses) {
  return std::none_of(diagnoses.begin(), diagnoses.end(),
                      [](const Diagnosis& one) { return one.level == Level::problem; });
}

}  // namespace trocar::cli
