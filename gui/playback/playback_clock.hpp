// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <array>
#include <optional>

#include "gui/playback/log_feed.hpp"

namespace trocar::gui {

/// Where playback stands in a log: it goes on by itself, or by steps and jumps. What the store
/// shows ends there.
class PlaybackClock : public QObject {
  Q_OBJECT

 public:
  static constexpr std::array speeds = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0};

  PlaybackClock(DataStore& store, LogFeed& feed, QObject* parent = nullptr);

  double now() const { return now_; }  // [s] of the run
  bool is_playing() const { return timer_.isActive(); }
  double speed() const { return speed_; }
  const std::optional<LogFeed::Span>& loop() const { return loop_; }

  void play();  // from the start again when it stands at the end
  void hold();  // stands still
  void toggle() { is_playing() ? hold() : play(); }
  void set_speed(double speed);       // @param speed of `speeds`, the nearest of them is taken
  void seek(double time);             // [s], kept within the run
  void step(int rows);                // forward, or back where below 0: holds
  void jump_to_event(int direction);  // the next that is_marked(), or the one before: holds
  /// Playing goes round between two times. @param span none: does not; empty or turned round: none
  void set_loop(std::optional<LogFeed::Span> span);
  /// As if `seconds` of real time had passed while it played.
  void advance(double seconds);

 Q_SIGNALS:
  void moved(double now);
  void changed();  // playing, speed, loop

 private:
  const Track* finest() const;  // the thread with most rows
  void move(double time);
  void follow_log();

  DataStore& store_;
  LogFeed& feed_;
  QTimer timer_;
  QElapsedTimer since_;
  double now_ = 0.0;
  double speed_ = 1.0;
  std::optional<LogFeed::Span> loop_;
};

}  // namespace trocar::gui
