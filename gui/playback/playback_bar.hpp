// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "gui/playback/time_line.hpp"

namespace trocar::gui {

/// Playback of a log as the operator has it: play, speed, steps, jumps, a loop, the run of several,
/// the time line, and what of the log is there.
class PlaybackBar : public QWidget {
  Q_OBJECT

 public:
  PlaybackBar(DataStore& store, LogFeed& feed, PlaybackClock& clock, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);

 private:
  QPushButton* add_button(QLayout& row, const char* name, const QString& text,
                          const QString& accessible);
  void add_moves(QLayout& row);
  void add_speeds(QLayout& row);
  void add_loop(QLayout& row);
  void add_state(QLayout& row);
  void mark_loop(bool begin);
  void follow_clock();
  void follow_log();

  LogFeed& feed_;
  PlaybackClock& clock_;
  TimeLine* line_;
  QPushButton *play_ = nullptr, *no_loop_ = nullptr, *cancel_ = nullptr;
  QComboBox *speed_ = nullptr, *run_ = nullptr;
  QLabel *now_ = nullptr, *summary_ = nullptr, *problem_ = nullptr;
};

}  // namespace trocar::gui
