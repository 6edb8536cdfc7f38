// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "gui/playback/playback_bar.hpp"
#include "gui/window/main_window.hpp"

namespace trocar::gui {

/// A log in the window of a live run: the same pages, with a bar that plays it.
class Replay : public QObject {
  Q_OBJECT

 public:
  /// @throw std::runtime_error when it cannot be read, is no log or has no rows
  explicit Replay(const std::string& path);
  ~Replay() override;

  MainWindow& window() { return *window_; }
  LogFeed& feed() { return feed_; }
  PlaybackClock& clock() { return clock_; }

 private:
  DataStore data_;
  LogFeed feed_{data_};
  PlaybackClock clock_{data_, feed_};
  std::unique_ptr<Operator> operator_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace trocar::gui
