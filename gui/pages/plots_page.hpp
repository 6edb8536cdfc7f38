// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCheckBox>
#include <QElapsedTimer>
#include <QSlider>

#include "gui/analysis/plot_layout.hpp"
#include "gui/analysis/value_table.hpp"
#include "gui/operate/operator.hpp"
#include "gui/pages/cell_view.hpp"
#include "gui/pages/signal_list.hpp"
#include "gui/pages/trigger_bar.hpp"
#include "gui/plots/plot_board.hpp"

namespace trocar::gui {

/// Plots of any signals: what to look at, when, and the numbers of it.
class PlotsPage : public Page {
  Q_OBJECT

 public:
  explicit PlotsPage(Operator& operators, QWidget* parent = nullptr);

  QString title() const override { return "Plots"; }
  QKeySequence shortcut() const override { return QKeySequence("Ctrl+2"); }
  void refresh() override;
  void set_theme(const Theme& theme) override;
  void freeze(std::optional<double> at) override;

  void show_layout(const PlotLayout& layout);
  PlotLayout layout_shown() const;
  /// @throw std::runtime_error, std::invalid_argument: what is wrong with the file
  void load_layout(const QString& path) { show_layout(read_layout_file(path)); }
  void export_table(const QString& path);    // of what is visible, as CSV
  void export_picture(const QString& path);  // .png, .svg or .pdf

  PlotBoard& board() { return *board_; }
  const Trigger& trigger() const { return trigger_; }
  TimeWindow window_shown() const;
  const std::optional<Cursors>& cursors() const { return cursors_; }
  void set_cursors(const std::optional<Cursors>& cursors);

 private:
  void build();
  QWidget* make_head();
  QHBoxLayout* make_scrub();
  QWidget* make_menu(const char* name, const QString& text,
                     const std::vector<std::pair<QString, std::function<void()>>>& entries);
  void connect_all();
  void choose_signals();
  void add_xy();
  void ask_title();
  void scrub(double seconds);
  void zoom(double factor);
  void look_at(double end, double span);
  void follow_trigger();
  void take_trigger();
  void show_level();
  void show_view();
  void show_values();
  void show_scrub();
  void move_cursor(int which, double at);
  void remove_row();
  void ask_file(const QString& what, const QString& filter, bool save,
                const std::function<void(const QString&)>& act);

  Operator& operator_;
  DataStore& data_;
  SignalList* list_;
  PlotBoard* board_;
  QDoubleSpinBox* span_;
  QCheckBox *cursors_box_, *events_box_, *trigger_box_;
  QLabel *difference_, *notice_;
  TriggerBar* trigger_bar_;
  QSlider* scrub_;
  QLabel* where_;
  CellTable table_{ValueTable::header()};
  CellView* values_;
  ValueTable value_rows_;

  TimeView view_;
  std::optional<Cursors> cursors_;
  Trigger trigger_;
  bool is_chosen_ = false;  // by the user: what the graph names does not replace it
  bool showing_ = false;
  QElapsedTimer shown_;  // since the numbers were
};

}  // namespace trocar::gui
