// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "gui/operate/run_status.hpp"

namespace trocar::gui {

/// The force at the handle against its cap, as a bar and a number. Grey where it is stale.
class ForceMeter : public QWidget {
  Q_OBJECT

 public:
  explicit ForceMeter(QWidget* parent = nullptr);
  void show_status(const RunStatus& status, const Theme& theme);
  QSize sizeHint() const override { return {260, 108}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  RunStatus status_;
  Theme theme_ = Theme::light();
};

}  // namespace trocar::gui
