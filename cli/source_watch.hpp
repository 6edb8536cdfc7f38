// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "framework/run_control.hpp"

namespace trocar::cli {

/// Looks at the files of a running graph's laws, and reloads those that were saved anew.
class SourceWatch {
 public:
  /// Looks when it is time to. @return whether there was something to do
  bool look(RunControl& control);

 private:
  void tell_what_is_watched(const std::vector<Reloads::Part>& parts);
  void tell(const std::string& text) const;
  bool reload(const Reloads::Part& part, RunControl& control);

  std::map<std::string, std::filesystem::file_time_type> seen_;  // by the component's name
  std::int64_t next_ns_ = 0;
  bool told_ = false;  // what is watched
};

}  // namespace trocar::cli
