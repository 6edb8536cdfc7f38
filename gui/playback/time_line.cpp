// SPDX-License-Identifier: Apache-2.0
#include "gui/playback/time_line.hpp"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace trocar::gui {
namespace {

constexpr double near_px = 6.0;

}  // namespace

TimeLine::TimeLine(DataStore& store, LogFeed& feed, PlaybackClock& clock, QWidget* parent)
    : QAbstractSlider(parent), store_(store), feed_(feed), clock_(clock) {
  setObjectName("time_line");
  setAccessibleName(tr("Time line of the log"));
  setFocusPolicy(Qt::StrongFocus);
  setOrientation(Qt::Horizontal);
  connect(&feed_, &LogFeed::opened, this, &TimeLine::follow_log);
  connect(&feed_, &LogFeed::advanced, this, &TimeLine::follow_log);
  connect(&clock_, &PlaybackClock::moved, this, &TimeLine::follow_clock);
  connect(&clock_, &PlaybackClock::changed, this, qOverload<>(&QWidget::update));
  // Also of those who ask by accessibility.
  connect(this, &QAbstractSlider::valueChanged, this, [this](int value) {
    if (!following_) clock_.seek(feed_.whole().from + unit * value);
  });
  follow_log();
}

void TimeLine::set_theme(const Theme& theme) {
  theme_ = theme;
  update();
}

void TimeLine::follow_log() {
  following_ = true;
  const LogFeed::Span whole = feed_.whole();
  setRange(0, static_cast<int>(std::min(2e9, (whole.to - whole.from) / unit)));
  setSingleStep(1);
  setPageStep(std::max(1, maximum() / 10));
  following_ = false;
  follow_clock();
}

void TimeLine::follow_clock() {
  following_ = true;
  setValue(static_cast<int>(std::lround((clock_.now() - feed_.whole().from) / unit)));
  following_ = false;
  setAccessibleDescription(
      tr("%1 s of %2 s").arg(clock_.now(), 0, 'f', 3).arg(feed_.whole().to, 0, 'f', 3));
  update();
}

void TimeLine::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const RunEvent* marked = event_near(event->position().x());
  clock_.seek(marked != nullptr ? marked->time : time_at(event->position().x()));
}

void TimeLine::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) clock_.seek(time_at(event->position().x()));
}

void TimeLine::wheelEvent(QWheelEvent* event) {
  event->ignore();  // a page that scrolls must not move the time
}

void TimeLine::keyPressEvent(QKeyEvent* event) {
  const bool far = (event->modifiers() & Qt::ShiftModifier) != 0;
  const double tenth = 0.1 * (feed_.whole().to - feed_.whole().from);
  const auto go = [&](int direction) {
    if (far)
      clock_.seek(clock_.now() + direction);
    else
      clock_.step(direction);
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return go(-1);
    case Qt::Key_Right:
      return go(1);
    case Qt::Key_PageUp:
      return clock_.seek(clock_.now() - tenth);
    case Qt::Key_PageDown:
      return clock_.seek(clock_.now() + tenth);
    case Qt::Key_Home:
      return clock_.seek(feed_.whole().from);
    case Qt::Key_End:
      return clock_.seek(feed_.whole().to);
    default:
      event->ignore();
  }
}

const RunEvent* TimeLine::event_near(double x) const {
  const RunEvent* nearest = nullptr;
  double distance = near_px;
  for (const RunEvent& event : store_.events()) {
    const double its = std::abs(x_of(event.time) - x);
    if (!is_marked(event) || its >= distance) continue;
    nearest = &event;
    distance = its;
  }
  return nearest;
}

bool TimeLine::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QAbstractSlider::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const RunEvent* marked = event_near(help->pos().x());
  const QString text = marked == nullptr ? tr("%1 s").arg(time_at(help->pos().x()), 0, 'f', 3)
                                         : tr("%1 s: %2 %3 %4")
                                               .arg(marked->time, 0, 'f', 3)
                                               .arg(QString::fromStdString(marked->kind),
                                                    QString::fromStdString(marked->source),
                                                    QString::fromStdString(marked->detail));
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

}  // namespace trocar::gui
