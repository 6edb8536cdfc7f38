// SPDX-License-Identifier: Apache-2.0
#include "gui/plots/plot_marks.hpp"

namespace trocar::gui {
namespace {

constexpr std::size_t most_events = 24;  // that are marked
constexpr qsizetype longest = 32;

/// What was remarked, or what it was and of whom.
QString mark_text(const RunEvent& event) {
  const std::string text = event.kind == "annotated" ? event.detail
                           : event.source.empty()    ? event.kind
                                                     : event.kind + " " + event.source;
  const QString shown = QString::fromStdString(text).simplified();
  return shown.size() <= longest ? shown : shown.left(longest - 1) + "…";
}

}  // namespace

void PlotMarks::Mark::move(double at) {
  line->point1->setCoords(at, 0.0);
  line->point2->setCoords(at, 1.0);
  text->position->setCoords(at, text->position->coords().y());
}

void PlotMarks::Mark::set_visible(bool visible) {
  line->setVisible(visible);
  text->setVisible(visible);
}

void PlotMarks::Mark::set_colour(const QColor& colour, Qt::PenStyle style) {
  line->setPen(QPen(colour, 1, style));
  text->setColor(colour);
}

PlotMarks::Mark PlotMarks::make(QCPLayer& layer, const QString& text, bool at_top) {
  Mark mark{new QCPItemStraightLine(&plot_), new QCPItemText(&plot_)};
  mark.line->setLayer(&layer);
  mark.text->setLayer(&layer);
  mark.text->setText(text);
  mark.text->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  mark.text->position->setCoords(0.0, at_top ? 0.0 : 1.0);
  mark.text->setPositionAlignment((at_top ? Qt::AlignTop : Qt::AlignBottom) | Qt::AlignLeft);
  mark.text->setPadding({2, 0, 2, 0});
  mark.set_visible(false);
  return mark;
}

PlotMarks::PlotMarks(QCustomPlot& plot, QCPLayer& layer)
    : plot_(plot), level_(new QCPItemStraightLine(&plot)) {
  cursors_ = {make(layer, "A", true), make(layer, "B", true)};
  for (std::size_t i = 0; i < most_events; ++i) events_.push_back(make(layer, "", false));
  level_->setLayer(&layer);
  level_->setVisible(false);
}

void PlotMarks::set_cursors(const std::optional<std::array<double, 2>>& cursors) {
  for (std::size_t i = 0; i < cursors_.size(); ++i) {
    cursors_[i].set_visible(cursors.has_value());
    if (cursors) cursors_[i].move((*cursors)[i]);
  }
}

void PlotMarks::set_level(std::optional<double> level) {
  level_at_ = level;
  level_->setVisible(level.has_value());
  if (!level) return;
  level_->point1->setCoords(0.0, *level);
  level_->point2->setCoords(1.0, *level);
}

void PlotMarks::show_events(const DataStore& data, const TimeWindow& window) {
  std::size_t used = 0;
  if (events_shown_)
    for (std::size_t i = data.events_shown(); i-- > 0 && used < events_.size();) {
      const RunEvent& event = data.events()[i];
      if (event.time < window.begin) break;
      if (event.time > window.end || !is_marked(event)) continue;
      Mark& mark = events_[used++];
      mark.set_visible(true);
      mark.move(event.time - window.zero);
      mark.text->setText(mark_text(event));
    }
  for (std::size_t i = used; i < events_.size(); ++i) events_[i].set_visible(false);
}

void PlotMarks::set_theme(const Theme& theme) {
  for (Mark& mark : cursors_) mark.set_colour(theme.accent, Qt::SolidLine);
  for (Mark& mark : events_) mark.set_colour(theme.warning, Qt::DashDotLine);
  level_->setPen(QPen(theme.accent, 1, Qt::DashDotLine));
}

}  // namespace trocar::gui
