// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "gui/device/camera.hpp"
#include "gui/device/mechanism_picture.hpp"
#include "gui/window/page.hpp"

namespace trocar::gui {

/// A live picture of the device in space. It is turned by dragging or the arrow keys, and made
/// larger by the wheel or + and -; Home takes that back, W shows where the tool can reach.
class MechanismView : public QWidget {
  Q_OBJECT

 public:
  explicit MechanismView(const Sources& sources, QWidget* parent = nullptr);

  /// Shows the newest row.
  void refresh();
  void set_theme(const Theme& theme);

  void set_workspace_shown(bool shown);
  bool workspace_shown() const { return workspace_shown_; }
  /// null until it is asked for, and where there is no laparoscope
  const WorkspaceOutline* workspace() const { return workspace_.get(); }

  const Scene& scene() const { return scene_; }
  const MechanismPose& pose() const { return pose_; }
  const Camera& camera() const { return camera_; }
  /// The pose in words, and what is wrong with what is seen.
  QString description() const;

  QSize sizeHint() const override { return {480, 480}; }
  QSize minimumSizeHint() const override { return {200, 200}; }

 Q_SIGNALS:
  void workspace_shown_changed(bool shown);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void read_graph();
  void search_workspace();
  QString notice() const;  // why what is seen is not what is, or ""
  void paint_picture(QPainter& painter);
  void paint_texts(QPainter& painter);

  Sources sources_;
  Scene scene_;
  MechanismPose pose_;
  Camera camera_;
  Theme theme_ = Theme::light();
  bool workspace_shown_ = false;
  std::unique_ptr<WorkspaceOutline> workspace_;
  QTimer search_;
  QElapsedTimer told_;  // since the description was given to those who read it aloud
  std::optional<QPointF> dragged_from_;
};

}  // namespace trocar::gui
