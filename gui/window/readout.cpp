// SPDX-License-Identifier: Apache-2.0
#include "gui/window/readout.hpp"

namespace trocar::gui {
namespace {

constexpr int least_width = 24;  // [pixels]
constexpr int sign_room = 22;    // padding left and right

}  // namespace

Readout::Readout(const char* name, const QString& what, QWidget* parent)
    : QLabel(parent), what_(what) {
  setObjectName(name);
  setAccessibleName(what);
  setTextFormat(Qt::PlainText);
}

void Readout::show_text(const QString& text) {
  if (text == text_) return;
  text_ = text;
  setAccessibleName(what_ + ": " + text_);
  setToolTip(text_);
  updateGeometry();
  cut();
}

void Readout::cut() {
  ensurePolished();
  const QString shown = fontMetrics().elidedText(text_, Qt::ElideRight, width() - sign_room);
  if (shown != text()) setText(shown);
}

QSize Readout::sizeHint() const {
  ensurePolished();
  return {fontMetrics().horizontalAdvance(text_) + sign_room + 2, QLabel::sizeHint().height()};
}

QSize Readout::minimumSizeHint() const {
  if (whole_) return sizeHint();
  return {text_.isEmpty() ? 0 : least_width, QLabel::minimumSizeHint().height()};
}

void Readout::paint_sign(const QColor& ground, const QColor& ink) {
  set_style(QString("background:%1; color:%2; padding:4px 10px; font-weight:bold; font-size:15px;"
                    "border-radius:3px;")
                .arg(ground.name(), ink.name()));
}

void Readout::paint_plain(const QColor& ink) {
  set_style(QString("color:%1; padding:4px 10px;").arg(ink.name()));
}

/// A style is parsed anew each time it is set, and this is called for each frame.
void Readout::set_style(const QString& style) {
  if (style == style_) return;
  style_ = style;
  setStyleSheet(style);
  updateGeometry();
  cut();
}

void Readout::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  cut();
}

}  // namespace trocar::gui
