// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QKeySequence>
#include <QString>
#include <QWidget>
#include <optional>

#include "gui/data/data_store.hpp"
#include "gui/data/live_feed.hpp"
#include "gui/link/stream_client.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

class LogFeed;

/// What pages look at: the data, wherever they come from, and the link where they are live.
struct Sources {
  DataStore& data;
  StreamClient* link = nullptr;  // null: a log is played
  LiveFeed* live = nullptr;
  LogFeed* log = nullptr;  // that is played
};

/// Between numbers that people have to read.
inline constexpr int show_every_ms = 200;

/// A sheet of the window. It has models without widgets beneath it, and shows them.
class Page : public QWidget {
  Q_OBJECT

 public:
  explicit Page(QWidget* parent = nullptr) : QWidget(parent) {}

  virtual QString title() const = 0;
  virtual QKeySequence shortcut() const = 0;  // that brings it to the front
  /// Shows the newest: called some 30 times a second while it is seen, and not otherwise.
  virtual void refresh() = 0;
  virtual void set_theme(const Theme& theme) = 0;
  /// The pictures stop at that time [s], or follow again; what is not over time goes on.
  virtual void freeze(std::optional<double>) {}

 Q_SIGNALS:
  /// Of the whole window.
  void freeze_wanted(std::optional<double> at);
};

}  // namespace trocar::gui
