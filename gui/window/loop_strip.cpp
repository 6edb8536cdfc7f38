// SPDX-License-Identifier: Apache-2.0
#include "gui/window/loop_strip.hpp"

namespace trocar::gui {
namespace {

constexpr double narrow_margin = 0.2;  // of the period

}  // namespace

LoopStrip::LoopStrip(QWidget* parent) : Readout("loop", "health of the loop", parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

QString LoopStrip::text(const RunStatus& status) {
  if (status.rate <= 0) return "LOOP: no rows yet";
  QString text = QString("LOOP %1 Hz   late p99 %2 µs   margin %3 %   missed %4")
                     .arg(status.rate, 0, 'f', 0)
                     .arg(1e6 * status.late_p99, 0, 'f', 0)
                     .arg(100.0 * status.margin, 0, 'f', 0)
                     .arg(status.missed);
  if (status.has_report_age)
    text += QString("   report age %1 ms").arg(1e3 * status.report_age, 0, 'f', 1);
  text += QString("   time %1 s   tick %2").arg(status.time, 0, 'f', 1).arg(status.tick);
  if (status.state == RunState::unknown) text += "   OLD";
  if (status.margin < narrow_margin) text += "   NARROW";
  return text;
}

void LoopStrip::refresh(const RunStatus& status, const Theme& theme) {
  show_text(text(status));
  paint_plain(status.stale()                  ? theme.muted
              : status.margin < narrow_margin ? theme.warning
                                              : theme.text);
}

}  // namespace trocar::gui
