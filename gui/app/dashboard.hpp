// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QUrl>
#include <memory>

#include "gui/app/runtime.hpp"
#include "gui/window/main_window.hpp"

namespace trocar::gui {

/// A live run in a window: link, data, what an operator can do, and the pages.
class Dashboard : public QObject {
  Q_OBJECT

 public:
  Dashboard();

  /// Starts a runtime of its own and attaches to it.
  void run(const QString& script, const QStringList& options);
  /// Attaches to one that is running.
  void attach(const QUrl& url);

  MainWindow& window() { return *window_; }
  Operator& operators() { return *operator_; }
  Runtime* runtime() { return runtime_.get(); }  // null when it is not ours
  DataStore& data() { return data_; }

 private:
  void open_window(const QString& subject);
  void hear_end(const QString& why, bool by_force);

  DataStore data_;
  StreamClient link_;
  LiveFeed live_{link_, data_};
  std::unique_ptr<Operator> operator_;
  std::unique_ptr<MainWindow> window_;
  std::unique_ptr<Runtime> runtime_;
};

}  // namespace trocar::gui
