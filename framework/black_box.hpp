// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "framework/recording/triggered_log.hpp"

namespace trocar {

/// The last seconds before a trip, which every session of the command keeps.
struct BlackBoxOptions {
  double before = 5.0;  // [s]
  double after = 1.0;   // [s]
  /// Of the first file. Without one it is NAME.blackbox-1.mcap, beside the log where there is one,
  /// else after the script in the current folder. A file that is there is never overwritten.
  std::optional<std::string> file{};
};

/// Every fault is a reason to write.
class FaultTrigger final : public Trigger {
 public:
  explicit FaultTrigger(Window window) : window_(window) {}
  Window begin(const std::vector<RowLayout>&, const WiredGraph&) override { return window_; }
  bool event(std::size_t group, const Event& event) override;
  /// "speed in arm at tick 812 (0.812 s): axis 2, 2.4 beyond 2"
  std::string cause() const override;

 private:
  Window window_;
  Event fault_;
};

}  // namespace trocar
