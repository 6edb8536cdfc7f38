// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMainWindow>
#include <QStackedWidget>
#include <QTabBar>
#include <QTimer>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "gui/operate/operator.hpp"
#include "gui/window/loop_strip.hpp"
#include "gui/window/page.hpp"
#include "gui/window/stale_veil.hpp"
#include "gui/window/state_strip.hpp"

namespace trocar::gui {

/// The operator's window: what is always in sight at its top and bottom, pages between, and a
/// border that says whether this is live, simulated or a replay.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// @param subject what is looked at, for the title: a script, a log, an address
  MainWindow(Operator& operators, const QString& subject);

  void add_page(Page* page);
  /// Always in sight too, below the pages.
  void add_bar(QWidget* bar);
  Page* page() const;
  void show_page(int number);
  const std::vector<Page*>& pages() const { return pages_; }
  void set_theme(const Theme& theme);
  const Theme& theme() const { return theme_; }
  /// Of a log: the script's mark, which stands in every picture. A run tells its own.
  void set_mark(const QString& mark) { mark_ = mark; }
  /// A key of the window's, with what it does, for the sheet.
  void add_key(const QKeySequence& key, const QString& what, const std::function<void()>& act);
  /// Each key with what it does.
  const std::vector<std::pair<QString, QString>>& keys() const { return keys_; }

  /// Everything anew, now; a timer does it 30 times a second.
  void refresh();
  void show_shortcuts();
  /// Stops all plots, or lets them follow again. The run and its recording go on.
  void toggle_freeze();
  void freeze(std::optional<double> at);  // [s] of what is shown; none: they follow
  bool frozen() const { return frozen_at_.has_value(); }
  StateStrip& state_strip() { return *state_; }

 Q_SIGNALS:
  void theme_changed(const trocar::gui::Theme& theme);

 protected:
  /// F12 stops wherever the focus is, also in a dialog.
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void build();
  void add_keys();
  void refresh_marks();

  Operator& operator_;
  QString subject_, mark_;
  StateStrip* state_;
  QTabBar* tabs_;
  QStackedWidget* stack_;
  StaleVeil* veil_;
  Readout *mark_label_, *frozen_;
  LoopStrip* loop_;
  std::vector<Page*> pages_;
  std::vector<std::pair<QString, QString>> keys_;
  std::optional<double> frozen_at_;  // [s]
  QTimer timer_;
  Theme theme_ = Theme::light();
};

}  // namespace trocar::gui
