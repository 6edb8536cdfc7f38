// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSplitter>
#include <vector>

#include "gui/plots/plot_pane.hpp"

namespace trocar::gui {

/// Plots under each other that show the same time. One of them is chosen: what is added goes there.
class PlotBoard : public QWidget {
  Q_OBJECT

 public:
  explicit PlotBoard(DataStore& store, QWidget* parent = nullptr);

  void show_plots(const std::vector<PlotDescription>& plots);
  std::vector<PlotDescription> plots() const;
  std::vector<std::string> signal_names() const;  // of all plots, without repeats
  int count() const { return static_cast<int>(panes_.size()); }

  void add_plot(const PlotDescription& plot);
  void remove_chosen();
  void set_title(const QString& title);  // of the chosen plot
  void choose(int plot);
  int chosen() const { return chosen_; }  // −1: there is no plot
  /// To the chosen plot, or to a new one where there is none.
  void add_signals(const QStringList& names);
  void remove_signal(int plot, const std::string& name);

  void set_view(const TimeView& view);
  void set_cursors(const std::optional<Cursors>& cursors);
  void set_level(const std::string& signal, std::optional<double> level);
  void set_events_shown(bool shown);
  void set_theme(const Theme& theme);
  void refresh();

  /// All plots with their legends, by the file's ending, on white.
  /// @throw std::runtime_error, std::invalid_argument as save_picture()
  void save(const QString& path);

 Q_SIGNALS:
  void plots_changed();  // or their curves
  void scrubbed(double seconds);
  void zoomed(double factor);
  void cursor_moved(int which, double at);

 private:
  PlotPane* make_pane(const PlotDescription& plot);
  void delete_pane(std::size_t index);
  void number_panes();

  DataStore& data_;
  QSplitter* split_;
  std::vector<PlotPane*> panes_;
  int chosen_ = -1;
  TimeView view_;
  std::optional<Cursors> cursors_;
  bool events_shown_ = true;
  Theme theme_ = Theme::light();
};

}  // namespace trocar::gui
