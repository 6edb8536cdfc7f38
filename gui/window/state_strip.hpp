// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "gui/operate/operator.hpp"

namespace trocar::gui {

/// What is always in sight at the top: what is looked at, its state, the stop, the first fault.
class StateStrip : public QWidget {
  Q_OBJECT

 public:
  explicit StateStrip(Operator& operators, QWidget* parent = nullptr);

  void refresh();
  void set_theme(const Theme& theme);
  void say(const QString& remark);  // what the runtime answered, for some seconds

 private:
  void show_stop();
  void show_fault();
  QLabel* label(const char* name, const char* accessible);
  static void paint(QLabel& label, const QColor& back, const QColor& text);

  Operator& operator_;
  QLabel *mode_, *state_, *hand_, *recording_, *link_, *fault_, *remark_;
  QPushButton *stop_, *acknowledge_, *record_, *engage_;
  Theme theme_ = Theme::light();
};

}  // namespace trocar::gui
