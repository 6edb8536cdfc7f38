// SPDX-License-Identifier: Apache-2.0
#include "gui/window/stale_veil.hpp"

#include <QEvent>
#include <QPainter>

namespace trocar::gui {
namespace {

constexpr int veil_alpha = 110;

}  // namespace

StaleVeil::StaleVeil(QWidget* covered) : QWidget(covered) {
  setObjectName("stale_veil");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  covered->installEventFilter(this);
  hide();
}

void StaleVeil::set_theme(const Theme& theme) {
  theme_ = theme;
  update();
}

bool StaleVeil::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) resize(static_cast<QWidget*>(watched)->size());
  return QWidget::eventFilter(watched, event);
}

void StaleVeil::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QColor ink = theme_.muted;
  ink.setAlpha(veil_alpha);
  painter.fillRect(rect(), QBrush(ink, Qt::BDiagPattern));
}

}  // namespace trocar::gui
