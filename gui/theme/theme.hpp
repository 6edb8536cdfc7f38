// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPalette>
#include <QPen>
#include <array>
#include <cstddef>

namespace trocar::gui {

/// The colours of everything that is drawn. A state is never told by colour alone.
struct Theme {
  bool dark = false;
  QColor window, surface, text, muted, grid, accent;
  QColor ok, warning, danger, on_danger;  // on_danger: text on danger
  QColor live, simulated, replay;         // borders of what is looked at

  static Theme light();
  static Theme dark_one();

  QPalette palette() const;

  /// Of the n-th curve of a plot: seven colours that colour-blind people tell apart, then the same
  /// dashed, then dotted (Okabe and Ito, Color Universal Design, 2008; yellow stands only on dark
  /// ground).
  QPen curve(std::size_t n) const;

 private:
  std::array<QColor, 7> curves_;
};

}  // namespace trocar::gui
