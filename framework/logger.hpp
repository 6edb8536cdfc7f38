// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"

namespace trocar {

/// Says where a session is recorded and which signals are kept. It does nothing in the loop: rows
/// are captured whole and thinned out on the recorder's thread.
class Logger final : public Component {
 public:
  Parameter<std::string> file{
      this, "file", {.initial = "trocar.mcap", .doc = "where the log is written (MCAP)"}};
  Parameter<Literal> signals{
      this,
      "signals",
      {.initial = "all", .doc = "ports to record, or \"all\"; a device's are always recorded"}};

  void step(const Tick&) RT_SAFE override {}
};

}  // namespace trocar
