// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace trocar::test {

/// What the kernel test's scenario (guest/scenario.sh) wrote to the serial line, sorted. Other
/// lines, the kernel's own say, are passed over.
struct Transcript {
  std::map<std::string, std::string> states{};  // "@state NAME …": of the emulated device
  std::map<std::string, double> asked{};        // "@asked NAME TIME": time of the run [s]
  std::map<std::string, std::string> files{};   // between "@begin NAME" and "@end NAME"
  std::vector<std::string> failures{};          // "@failed …"
  std::string kernel{};
  double rate = 0.0;  // [Hz]
  bool complete = false;

  /// A file as JSON; discarded where it is none.
  nlohmann::json json(const std::string& name) const;
};

Transcript transcript_of(std::string_view text);

/// "effort zero 6.25 ms after the last good report and 5.00 ms after the last command" [ms].
struct EffortZero {
  bool said = false;
  double after_report = 0.0, after_command = 0.0;
};
EffortZero effort_zero(const std::string& state);

}  // namespace trocar::test
