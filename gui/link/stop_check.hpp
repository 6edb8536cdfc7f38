// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace trocar::gui {

/// Whether a stop that was asked for has come about. What confirms it is what the runtime says of
/// its device in the rows that it took after the request, never the request's own answer.
class StopCheck {
 public:
  static constexpr double patience_s = 0.25;

  void ask(double now_s);
  /// The runtime took the request, when the newest row that was seen was that of `newest_tick`.
  void accepted(std::int64_t newest_tick);
  bool asked() const { return asked_; }
  /// A row, or a run that has ended.
  void saw(double now_s, std::int64_t tick, bool rendering);
  void saw_end(double now_s);
  /// [s] from the request to what confirmed it.
  std::optional<double> confirmed_after() const { return after_; }
  bool overdue(double now_s) const { return asked_ && !after_ && now_s - asked_s_ > patience_s; }
  std::string text(double now_s) const;

 private:
  bool asked_ = false, accepted_ = false;
  double asked_s_ = 0.0;
  std::int64_t tick_ = 0;
  std::optional<double> after_;
};

}  // namespace trocar::gui
