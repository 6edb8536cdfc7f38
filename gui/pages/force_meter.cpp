// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/force_meter.hpp"

#include <QPainter>
#include <algorithm>

namespace trocar::gui {

ForceMeter::ForceMeter(QWidget* parent) : QWidget(parent) {
  setObjectName("force_meter");
  setAccessibleName("force at the handle");
  setMinimumSize(200, 108);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void ForceMeter::show_status(const RunStatus& status, const Theme& theme) {
  status_ = status;
  theme_ = theme;
  setAccessibleDescription(
      !status.has_force
          ? QString("the graph has no force")
          : QString("%1 N of %2 N").arg(status.force, 0, 'f', 1).arg(status.force_cap, 0, 'f', 0));
  update();
}

void ForceMeter::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.surface);
  const bool stale =
      status_.state == RunState::unknown || status_.state == RunState::ended || !status_.has_force;
  const QColor ink = stale ? theme_.muted : theme_.text;
  QFont font = painter.font();
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(theme_.text);
  painter.drawText(QRect(8, 4, width() - 16, 20), Qt::AlignLeft | Qt::AlignVCenter,
                   "FORCE AT HANDLE");
  QFont large = font;
  large.setPixelSize(28);
  painter.setFont(large);
  painter.setPen(ink);
  const QString force =
      status_.has_force ? QString("%1 N").arg(status_.force, 0, 'f', 1) : "no force";
  painter.drawText(QRect(8, 24, width() - 16, 34), Qt::AlignLeft | Qt::AlignVCenter, force);
  font.setBold(false);
  painter.setFont(font);
  const double cap = status_.force_cap;
  if (cap > 0)
    painter.drawText(QRect(8, 24, width() - 16, 34), Qt::AlignRight | Qt::AlignVCenter,
                     QString("cap %1 N").arg(cap, 0, 'f', 0));

  const QRectF bar(8, 62, width() - 16, 14);
  painter.setPen(theme_.muted);
  painter.setBrush(theme_.window);
  painter.drawRect(bar);
  const double share = cap > 0 ? std::clamp(status_.force / cap, 0.0, 1.0) : 0.0;
  const bool held_back = status_.scale < 0.999 && status_.force > 0;
  painter.setBrush(QBrush(stale       ? theme_.muted
                          : held_back ? theme_.warning
                                      : theme_.accent,
                          stale ? Qt::BDiagPattern : Qt::SolidPattern));
  painter.setPen(Qt::NoPen);
  painter.drawRect(QRectF(bar.x() + 1, bar.y() + 1, (bar.width() - 2) * share, bar.height() - 2));
  painter.setPen(ink);
  painter.drawText(QRect(8, 80, width() - 16, 22), Qt::AlignLeft | Qt::AlignVCenter,
                   QString("torque %1 N m   scale %2%3")
                       .arg(status_.moment, 0, 'f', 2)
                       .arg(status_.scale, 0, 'f', 2)
                       .arg(held_back ? "   SATURATED" : ""));
}

}  // namespace trocar::gui
