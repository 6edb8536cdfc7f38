// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QLabel>

namespace trocar::gui {

/// A text that changes, cut where there is no room: it never widens the window. Who cannot see it
/// hears what it is and what it says.
class Readout : public QLabel {
  Q_OBJECT

 public:
  /// @param what it tells, "state of the device"
  Readout(const char* name, const QString& what, QWidget* parent);

  /// It is never cut: short, and what people look for.
  void set_whole() { whole_ = true; }
  void show_text(const QString& text);
  const QString& whole_text() const { return text_; }
  /// As a sign: bold, on a ground of its own.
  void paint_sign(const QColor& ground, const QColor& ink);
  void paint_plain(const QColor& ink);
  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void cut();
  void set_style(const QString& style);

  QString what_, text_, style_;
  bool whole_ = false;
};

}  // namespace trocar::gui
