// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>
#include <memory>

#include "gui/app/dashboard.hpp"
#include "gui/app/options.hpp"
#include "gui/app/replay.hpp"
#include "gui/pages/start_page.hpp"

namespace trocar::gui {

/// What the program shows: a run, a log, or the start page until somebody chose one.
class Program {
 public:
  explicit Program(DashboardOptions options) : options_(std::move(options)) {}

  /// @return exit status
  int exec();

 private:
  int show_subject();  // exit status, 0: it is shown
  int show(MainWindow& window);
  bool load_layout(MainWindow& window);
  static int list_pages();
  void ask();
  void choose(std::string DashboardOptions::*subject, const QString& chosen);
  void take_picture(QWidget& window);

  DashboardOptions options_;
  std::unique_ptr<StartPage> start_;
  std::unique_ptr<Dashboard> dashboard_;
  std::unique_ptr<Replay> replay_;
};

}  // namespace trocar::gui
