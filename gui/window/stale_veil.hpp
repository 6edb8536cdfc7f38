// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// Hatching over values that nobody knows any more. What is beneath can still be used.
class StaleVeil : public QWidget {
  Q_OBJECT

 public:
  /// Covers `covered`, its parent, as long as it is shown.
  explicit StaleVeil(QWidget* covered);
  void set_theme(const Theme& theme);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_ = Theme::light();
};

}  // namespace trocar::gui
