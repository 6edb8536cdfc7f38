// SPDX-License-Identifier: Apache-2.0
#include "gui/plots/plot_pane.hpp"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/analysis/signal_tree.hpp"
#include "gui/data/shown_number.hpp"

namespace trocar::gui {
namespace {

constexpr int frame = 2;  // [px]

}  // namespace

PlotPane::PlotPane(DataStore& store, const PlotDescription& description, QWidget* parent)
    : QWidget(parent),
      data_(store),
      description_(description),
      hint_(new QLabel("Drag signals here, or choose some at the left and press Enter.", this)) {
  setAcceptDrops(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(frame, frame, frame, frame);
  layout->setSpacing(0);
  if (description.kind == PlotDescription::Kind::time) {
    time_ = new TimePlot(store, this);
    layout->addWidget(time_);
    gestures_ = new PlotGestures(time_->canvas());
    connect(gestures_, &PlotGestures::touched, this, &PlotPane::touched);
  } else {
    xy_ = new XyPlot(store, this);
    layout->addWidget(xy_);
    xy_->canvas().setFocusPolicy(Qt::StrongFocus);
    xy_->canvas().installEventFilter(this);
  }
  hint_->setAlignment(Qt::AlignCenter);
  layout->addWidget(hint_);
  QStringList names;
  for (const std::string& name : description.names) names << QString::fromStdString(name);
  description_.names.clear();
  add_signals(names);
  set_number(1);
}

PlotDescription PlotPane::description() const {
  return description_;
}

QCustomPlot& PlotPane::canvas() {
  return time_ != nullptr ? time_->canvas() : xy_->canvas();
}

void PlotPane::add_signals(const QStringList& names) {
  std::vector<std::string>& shown = description_.names;
  for (const QString& one : names) {
    const std::string name = one.toStdString();
    if (xy_ != nullptr) {
      if (shown.size() == 2) shown.erase(shown.begin() + (names.size() == 1 ? 1 : 0));
      shown.push_back(name);
    } else if (std::find(shown.begin(), shown.end(), name) == shown.end()) {
      shown.push_back(name);
      time_->add_curve(name);
    }
  }
  if (xy_ != nullptr && shown.size() == 2) xy_->set_signals(shown[0], shown[1]);
  hint_->setVisible(shown.empty());
  Q_EMIT curves_changed();
}

void PlotPane::remove_signal(const std::string& name) {
  if (time_ == nullptr) return;
  std::erase(description_.names, name);
  time_->remove_curve(name);
  hint_->setVisible(description_.names.empty());
  Q_EMIT curves_changed();
}

void PlotPane::set_number(int number) {
  number_ = number;
  const QString title = QString::fromStdString(description_.title);
  const QString shown = title.isEmpty() ? QString::number(number)
                                        : QString("%1  %2").arg(QString::number(number), title);
  time_ != nullptr ? time_->set_title(shown) : xy_->set_title(shown);
  const QString name = QString("plot %1").arg(number);
  setObjectName(name);
  canvas().setObjectName(name + " canvas");
  canvas().setAccessibleName(title.isEmpty() ? name : name + ", " + title);
}

void PlotPane::set_title(const QString& title) {
  description_.title = title.toStdString();
  set_number(number_);
}

void PlotPane::set_chosen(bool chosen) {
  chosen_ = chosen;
  update();
}

void PlotPane::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), chosen_ ? theme_.accent : theme_.grid);
  const int width = chosen_ ? frame : 1;
  painter.fillRect(rect().adjusted(width, width, -width, -width), theme_.surface);
}

void PlotPane::set_view(const TimeView& view) {
  time_ != nullptr ? time_->set_view(view) : xy_->set_view(view);
}

void PlotPane::set_cursors(const std::optional<Cursors>& cursors) {
  if (time_ == nullptr) return;
  time_->marks().set_cursors(cursors);
  gestures_->set_cursors(cursors);
}

void PlotPane::set_level(const std::string& name, std::optional<double> level) {
  if (time_ == nullptr) return;
  const auto& shown = description_.names;
  const auto signal = data_.find(name);
  const bool here = signal && std::find(shown.begin(), shown.end(), name) != shown.end();
  if (here && level)
    time_->marks().set_level(*level * shown_scale(signal->info().unit));
  else
    time_->marks().set_level(std::nullopt);
}

void PlotPane::set_events_shown(bool shown) {
  if (time_ != nullptr) time_->marks().set_events_shown(shown);
}

void PlotPane::set_theme(const Theme& theme) {
  theme_ = theme;
  QPalette text = hint_->palette();
  text.setColor(QPalette::WindowText, theme.muted);
  hint_->setPalette(text);
  time_ != nullptr ? time_->set_theme(theme) : xy_->set_theme(theme);
  update();
}

void PlotPane::refresh() {
  time_ != nullptr ? time_->refresh() : xy_->refresh();
}

QString PlotPane::heading() const {
  return time_ != nullptr ? time_->heading() : xy_->heading();
}

void PlotPane::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasFormat(SignalTree::mime_type)) event->acceptProposedAction();
}

void PlotPane::dropEvent(QDropEvent* event) {
  const QString names = QString::fromUtf8(event->mimeData()->data(SignalTree::mime_type));
  add_signals(names.split('\n', Qt::SkipEmptyParts));
  event->acceptProposedAction();
  Q_EMIT touched();
}

bool PlotPane::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::FocusIn)
    Q_EMIT touched();
  return false;
}

}  // namespace trocar::gui
