// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPushButton>
#include <QWidget>

#include "gui/operate/operator.hpp"
#include "gui/window/readout.hpp"

namespace trocar::gui {

/// What is always in sight at the top: what is looked at, its state, the stop, the first fault.
class StateStrip : public QWidget {
  Q_OBJECT

 public:
  explicit StateStrip(Operator& operators, QWidget* parent = nullptr);

  void refresh();
  void set_theme(const Theme& theme);
  void say(const QString& remark);  // what the runtime answered, for some seconds
  /// What stays until it is replaced: that the runtime ended, and why.
  void set_notice(const QString& notice);
  QPushButton& record_button() { return *record_; }
  QPushButton& engage_button() { return *engage_; }
  QPushButton& acknowledge_button() { return *acknowledge_; }
  QPushButton& stop_button() { return *stop_; }

 private:
  void build();
  void show_stop();
  void show_state();
  void show_link();
  void show_recording();
  void show_fault();
  void toggle_recording();
  QPushButton* button(const char* name, const QString& text, const QString& help);

  Operator& operator_;
  Readout *mode_, *state_, *hand_, *recording_, *link_, *fault_, *remark_, *banner_;
  QPushButton *stop_, *acknowledge_, *record_, *engage_;
  QString notice_;
  Theme theme_ = Theme::light();
};

}  // namespace trocar::gui
