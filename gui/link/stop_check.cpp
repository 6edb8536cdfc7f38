// SPDX-License-Identifier: Apache-2.0
#include "gui/link/stop_check.hpp"

#include <fmt/format.h>

namespace trocar::gui {

void StopCheck::ask(double now_s) {
  *this = {};
  asked_ = true;
  asked_s_ = now_s;
}

void StopCheck::accepted(std::int64_t newest_tick) {
  accepted_ = true;
  tick_ = newest_tick;
}

void StopCheck::saw(double now_s, std::int64_t tick, bool rendering) {
  if (accepted_ && !after_ && tick > tick_ && !rendering) after_ = now_s - asked_s_;
}

void StopCheck::saw_end(double now_s) {
  if (asked_ && !after_) after_ = now_s - asked_s_;
}

std::string StopCheck::text(double now_s) const {
  if (!asked_) return "";
  if (after_) return fmt::format("STOPPED, confirmed after {:.0f} ms", 1e3 * *after_);
  return overdue(now_s) ? "NOT CONFIRMED: use the hardware switch" : "stopping";
}

}  // namespace trocar::gui
