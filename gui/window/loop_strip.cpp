// SPDX-License-Identifier: Apache-2.0
#include "gui/window/loop_strip.hpp"

namespace trocar::gui {

LoopStrip::LoopStrip(QWidget* parent) : QLabel(parent) {
  setObjectName("loop");
  setAccessibleName("health of the loop");
}

QString LoopStrip::text(const RunStatus& status) {
  if (status.rate <= 0) return "LOOP: no rows yet";
  QString text = QString("LOOP %1 Hz   late p99 %2 µs   margin %3 %   missed %4")
                     .arg(status.rate, 0, 'f', 0)
                     .arg(1e6 * status.late_p99, 0, 'f', 0)
                     .arg(100.0 * status.margin, 0, 'f', 0)
                     .arg(status.missed);
  if (status.has_report_age)
    text += QString("   report age %1 ms").arg(1e3 * status.report_age, 0, 'f', 2);
  return text + QString("   time %1 s   tick %2").arg(status.time, 0, 'f', 2).arg(status.tick);
}

void LoopStrip::refresh(const RunStatus& status, const Theme& theme) {
  setText(text(status));
  const bool stale = status.state == RunState::unknown || status.state == RunState::ended;
  const QColor colour = stale ? theme.muted : status.margin < 0.2 ? theme.warning : theme.text;
  setStyleSheet(QString("color:%1; padding:3px 8px; font-family:monospace;").arg(colour.name()));
}

}  // namespace trocar::gui
