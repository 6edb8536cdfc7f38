// SPDX-License-Identifier: Apache-2.0
#include "gui/plots/plot_board.hpp"

#include <QTextDocument>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/figures/save_picture.hpp"

namespace trocar::gui {
namespace {

constexpr int screen_dpi = 96;
constexpr int height_unit = 1000;  // of a splitter's sizes, for a share of 1

}  // namespace

PlotBoard::PlotBoard(DataStore& store, QWidget* parent)
    : QWidget(parent), data_(store), split_(new QSplitter(Qt::Vertical, this)) {
  setObjectName("plot_board");
  split_->setObjectName("plot_split");
  split_->setChildrenCollapsible(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(split_);
}

PlotPane* PlotBoard::make_pane(const PlotDescription& plot) {
  auto* pane = new PlotPane(data_, plot, split_);
  pane->set_view(view_);
  pane->set_cursors(cursors_);
  pane->set_events_shown(events_shown_);
  pane->set_theme(theme_);
  connect(pane, &PlotPane::curves_changed, this, &PlotBoard::plots_changed);
  connect(pane, &PlotPane::touched, this, [this, pane] {
    choose(static_cast<int>(std::find(panes_.begin(), panes_.end(), pane) - panes_.begin()));
  });
  if (PlotGestures* gestures = pane->gestures()) {
    connect(gestures, &PlotGestures::scrubbed, this, &PlotBoard::scrubbed);
    connect(gestures, &PlotGestures::zoomed, this, &PlotBoard::zoomed);
    connect(gestures, &PlotGestures::cursor_moved, this, &PlotBoard::cursor_moved);
  }
  return pane;
}

void PlotBoard::show_plots(const std::vector<PlotDescription>& plots) {
  while (!panes_.empty()) delete_pane(panes_.size() - 1);
  QList<int> heights;
  for (const PlotDescription& plot : plots) {
    panes_.push_back(make_pane(plot));
    split_->addWidget(panes_.back());
    heights << static_cast<int>(height_unit * plot.height);
  }
  split_->setSizes(heights);
  number_panes();
  choose(panes_.empty() ? -1 : 0);
  Q_EMIT plots_changed();
}

std::vector<PlotDescription> PlotBoard::plots() const {
  std::vector<PlotDescription> plots;
  const QList<int> heights = split_->sizes();
  int whole = 0;
  for (const int height : heights) whole += height;
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    plots.push_back(panes_[i]->description());
    // Before it is shown a splitter has no sizes.
    if (whole > 0) {
      const double share = heights[static_cast<int>(i)] * static_cast<double>(count()) / whole;
      plots.back().height = std::max(0.01, std::round(100.0 * share) / 100.0);
    }
  }
  return plots;
}

std::vector<std::string> PlotBoard::signal_names() const {
  std::vector<std::string> names;
  for (const PlotPane* pane : panes_)
    for (const std::string& name : pane->description().names)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

void PlotBoard::add_plot(const PlotDescription& plot) {
  QList<int> heights = split_->sizes();
  int whole = 0;
  for (const int height : heights) whole += height;
  panes_.push_back(make_pane(plot));
  split_->addWidget(panes_.back());
  heights << (heights.empty() ? height_unit : whole / static_cast<int>(heights.size()));
  split_->setSizes(heights);
  number_panes();
  choose(count() - 1);
  Q_EMIT plots_changed();
}

void PlotBoard::delete_pane(std::size_t index) {
  PlotPane* pane = panes_[index];
  panes_.erase(panes_.begin() + static_cast<std::ptrdiff_t>(index));
  pane->disconnect(this);
  // What it was told by may still be on the way out of it.
  pane->setParent(nullptr);
  pane->deleteLater();
}

void PlotBoard::remove_chosen() {
  if (chosen_ < 0) return;
  delete_pane(static_cast<std::size_t>(chosen_));
  number_panes();
  choose(std::min(chosen_, count() - 1));
  Q_EMIT plots_changed();
}

void PlotBoard::set_title(const QString& title) {
  if (chosen_ >= 0) panes_[static_cast<std::size_t>(chosen_)]->set_title(title);
}

void PlotBoard::number_panes() {
  for (std::size_t i = 0; i < panes_.size(); ++i) panes_[i]->set_number(static_cast<int>(i) + 1);
}

void PlotBoard::choose(int plot) {
  chosen_ = plot;
  for (int i = 0; i < count(); ++i) panes_[static_cast<std::size_t>(i)]->set_chosen(i == plot);
}

void PlotBoard::add_signals(const QStringList& names) {
  if (chosen_ < 0) add_plot({});
  panes_[static_cast<std::size_t>(chosen_)]->add_signals(names);
}

void PlotBoard::remove_signal(int plot, const std::string& name) {
  if (plot >= 0 && plot < count()) panes_[static_cast<std::size_t>(plot)]->remove_signal(name);
}

void PlotBoard::set_view(const TimeView& view) {
  view_ = view;
  for (PlotPane* pane : panes_) pane->set_view(view);
}

void PlotBoard::set_cursors(const std::optional<Cursors>& cursors) {
  cursors_ = cursors;
  for (PlotPane* pane : panes_) pane->set_cursors(cursors);
}

void PlotBoard::set_level(const std::string& signal, std::optional<double> level) {
  for (PlotPane* pane : panes_) pane->set_level(signal, level);
}

void PlotBoard::set_events_shown(bool shown) {
  events_shown_ = shown;
  for (PlotPane* pane : panes_) pane->set_events_shown(shown);
}

void PlotBoard::set_theme(const Theme& theme) {
  theme_ = theme;
  for (PlotPane* pane : panes_) pane->set_theme(theme);
}

void PlotBoard::refresh() {
  for (PlotPane* pane : panes_) pane->refresh();
}

void PlotBoard::save(const QString& path) {
  const Theme shown = theme_;
  set_theme(Theme::light());  // paper is white
  refresh();
  const int head = fontMetrics().height() + 6;
  int wide = 1, high = 0;
  for (PlotPane* pane : panes_) {
    wide = std::max(wide, pane->canvas().width());
    high += head + pane->canvas().height();
  }
  const auto paint = [&](QCPPainter& painter) {
    painter.setPen(Qt::black);
    for (PlotPane* pane : panes_) {
      QTextDocument text;
      text.setDefaultFont(font());
      text.setDocumentMargin(2);
      text.setHtml(pane->heading());
      text.drawContents(&painter);
      painter.translate(0, head);
      pane->canvas().toPainter(&painter, pane->canvas().width(), pane->canvas().height());
      painter.translate(0, pane->canvas().height());
    }
  };
  try {
    save_picture(path, QSize(wide, std::max(1, high)), screen_dpi, paint);
  } catch (...) {
    set_theme(shown);
    throw;
  }
  set_theme(shown);
}

}  // namespace trocar::gui
