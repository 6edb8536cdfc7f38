// SPDX-License-Identifier: Apache-2.0
#include "gui/device/mechanism_view.hpp"

#include <QKeyEvent>
#include <QPainter>
#include <cmath>

#include "gui/device/mechanism_paint.hpp"
#include "gui/graph/graph_reading.hpp"
#include "gui/playback/log_feed.hpp"

namespace trocar::gui {
namespace {

constexpr double turn_of_a_key = 0.087;     // [rad], 5 deg
constexpr double turn_of_a_pixel = 0.0087;  // [rad]
constexpr double zoom_of_a_key = 1.25;
constexpr int tell_every_ms = 1000;
constexpr double slice_ms = 4.0;  // of a search, between frames

}  // namespace

MechanismView::MechanismView(const Sources& sources, QWidget* parent)
    : QWidget(parent), sources_(sources) {
  setObjectName("mechanism");
  setAccessibleName("picture of the device");
  setToolTip(
      "Drag or the arrow keys turn it, the wheel or + and − make it larger, Home takes that "
      "back, W shows where the tool can reach");
  setFocusPolicy(Qt::StrongFocus);
  if (sources.live != nullptr)
    connect(sources.live, &LiveFeed::graph_known, this, &MechanismView::read_graph);
  if (sources.log != nullptr)
    connect(sources.log, &LogFeed::opened, this, &MechanismView::read_graph);
  search_.setInterval(10);
  connect(&search_, &QTimer::timeout, this, &MechanismView::search_workspace);
  read_graph();
}

void MechanismView::read_graph() {
  scene_ = Scene::of(graph_of(sources_));
  workspace_.reset();
  set_workspace_shown(workspace_shown_);
  told_.invalidate();
  refresh();
}

void MechanismView::set_workspace_shown(bool shown) {
  if (shown && !workspace_ && scene_.laparoscope) {
    workspace_ = std::make_unique<WorkspaceOutline>(scene_.laparoscope->geometry,
                                                    scene_.laparoscope->limits);
    search_.start();
  }
  if (shown != workspace_shown_) {
    workspace_shown_ = shown;
    Q_EMIT workspace_shown_changed(shown);
  }
  update();
}

void MechanismView::search_workspace() {
  if (!workspace_ || workspace_->advance(slice_ms)) search_.stop();
  if (workspace_shown_) update();
}

void MechanismView::refresh() {
  pose_ = MechanismPose::of(scene_, sources_.data);
  if (!told_.isValid() || told_.elapsed() >= tell_every_ms) {
    setAccessibleDescription(description());
    told_.start();
  }
  update();
}

void MechanismView::set_theme(const Theme& theme) {
  theme_ = theme;
  update();
}

QString MechanismView::notice() const {
  if (sources_.link != nullptr && sources_.link->state() != LinkState::open)
    return "old: the link is " + QString(to_string(sources_.link->state()));
  if (graph_of(sources_).is_null()) return "the graph is not known yet";
  if (!scene_.laparoscope) return "no laparoscope: points in the device's frame";
  if (!pose_.assembled) return pose_.trouble;
  return pose_.violated.empty() ? "" : "beyond the device's limits";
}

QString MechanismView::description() const {
  const QString text = pose_.description(scene_);
  return notice().isEmpty() ? text : notice() + ". " + text;
}

void MechanismView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.surface);
  paint_picture(painter);
  paint_texts(painter);
  painter.setPen(QPen(hasFocus() ? theme_.accent : theme_.grid, hasFocus() ? 2.0 : 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
}

void MechanismView::paint_picture(QPainter& painter) {
  const Eigen::Quaterniond mount =
      scene_.laparoscope ? scene_.laparoscope->mount : Eigen::Quaterniond::Identity();
  std::vector<Eigen::Vector3d> extent = MechanismPicture::extent(scene_, pose_);
  for (Eigen::Vector3d& point : extent) point = mount * point;
  const double line = QFontMetricsF(painter.font()).height();
  camera_.fit(extent, QRectF(rect()).adjusted(16, 2.4 * line, -16, -1.2 * line));
  const bool stale = sources_.link != nullptr && sources_.link->state() != LinkState::open;
  MechanismPaint paint(painter, camera_, mount, theme_, stale);
  paint.paint(MechanismPicture::of(scene_, pose_, workspace_shown_ ? workspace_.get() : nullptr));
  paint.paint_triad({34.0, height() - 34.0}, 22.0);
  const double longest = std::min(120.0, 0.25 * width());
  paint.paint_scale_bar({width() - longest - 12.0, height() - 12.0}, longest);
}

void MechanismView::paint_texts(QPainter& painter) {
  const QFontMetricsF metrics(painter.font());
  const QRectF line(8, 4, width() - 16, metrics.height());
  const auto write = [&](int n, const QString& text, const QColor& colour) {
    painter.setPen(colour);
    painter.drawText(line.translated(0, n * line.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(text, Qt::ElideRight, line.width()));
  };
  const QString wrong = notice();
  if (pose_.assembled) {
    QString text = text_of_point(pose_.mechanism.tool.tip);
    if (pose_.force) text += QString("   %1 N").arg(pose_.force->norm(), 0, 'f', 1);
    write(0, "tip " + text, wrong.isEmpty() ? theme_.text : theme_.muted);
  }
  if (!wrong.isEmpty()) write(pose_.assembled ? 1 : 0, "⚠ " + wrong, theme_.warning);
  if (workspace_shown_ && workspace_ && wrong.isEmpty())
    write(1, workspace_->complete() ? "dotted: where the tip reaches" : "searching the workspace …",
          theme_.muted);
}

void MechanismView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      camera_.turn_by(turn_of_a_key, 0.0);
      break;
    case Qt::Key_Right:
      camera_.turn_by(-turn_of_a_key, 0.0);
      break;
    case Qt::Key_Up:
      camera_.turn_by(0.0, turn_of_a_key);
      break;
    case Qt::Key_Down:
      camera_.turn_by(0.0, -turn_of_a_key);
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      camera_.zoom_by(zoom_of_a_key);
      break;
    case Qt::Key_Minus:
      camera_.zoom_by(1.0 / zoom_of_a_key);
      break;
    case Qt::Key_Home:
      camera_.reset();
      break;
    case Qt::Key_W:
      set_workspace_shown(!workspace_shown_);
      break;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  update();
}

void MechanismView::mousePressEvent(QMouseEvent* event) {
  dragged_from_ = event->position();
}

void MechanismView::mouseMoveEvent(QMouseEvent* event) {
  if (!dragged_from_ || (event->buttons() & Qt::LeftButton) == 0) return;
  const QPointF moved = event->position() - *dragged_from_;
  camera_.turn_by(-turn_of_a_pixel * moved.x(), turn_of_a_pixel * moved.y());
  dragged_from_ = event->position();
  update();
}

void MechanismView::wheelEvent(QWheelEvent* event) {
  camera_.zoom_by(std::exp(event->angleDelta().y() / 600.0));
  update();
}

}  // namespace trocar::gui
