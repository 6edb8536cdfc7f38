// SPDX-License-Identifier: Apache-2.0
#include "gui/theme/theme.hpp"

namespace trocar::gui {

Theme Theme::light() {
  Theme theme;
  theme.dark = false;
  theme.window = "#f2f3f5";
  theme.surface = "#ffffff";
  theme.text = "#1a1d21";
  theme.muted = "#5c6570";
  theme.grid = "#d9dde2";
  theme.accent = "#0b63b0";
  theme.ok = "#00704f";
  theme.warning = "#8a5a00";
  theme.danger = "#c0171d";
  theme.on_danger = "#ffffff";
  theme.live = "#c0171d";
  theme.simulated = "#0b63b0";
  theme.replay = "#7a3f98";
  theme.curves_ = {QColor("#0072b2"), QColor("#d55e00"), QColor("#009e73"), QColor("#cc79a7"),
                   QColor("#1a1d21"), QColor("#56b4e9"), QColor("#b37d00")};
  return theme;
}

Theme Theme::dark_one() {
  Theme theme;
  theme.dark = true;
  theme.window = "#15181c";
  theme.surface = "#1e2227";
  theme.text = "#e9ecef";
  theme.muted = "#9aa4af";
  theme.grid = "#343a41";
  theme.accent = "#5aa9f0";
  theme.ok = "#3ecf9b";
  theme.warning = "#f0b341";
  theme.danger = "#e5383e";
  theme.on_danger = "#ffffff";
  theme.live = "#e5383e";
  theme.simulated = "#5aa9f0";
  theme.replay = "#c48be0";
  theme.curves_ = {QColor("#56b4e9"), QColor("#e69f00"), QColor("#2fc79a"), QColor("#e38cc0"),
                   QColor("#f0e442"), QColor("#e9ecef"), QColor("#f07d3c")};
  return theme;
}

QPalette Theme::palette() const {
  QPalette palette;
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::Base, surface);
  palette.setColor(QPalette::AlternateBase, window);
  palette.setColor(QPalette::Button, surface);
  palette.setColor(QPalette::ToolTipBase, surface);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                                         QPalette::ToolTipText, QPalette::BrightText})
    palette.setColor(role, text);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, muted);
  palette.setColor(QPalette::PlaceholderText, muted);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, dark ? window : surface);
  palette.setColor(QPalette::Link, accent);
  return palette;
}

QPen Theme::curve(std::size_t n) const {
  static constexpr std::array styles = {Qt::SolidLine, Qt::DashLine, Qt::DotLine};
  QPen pen(curves_[n % curves_.size()], 1.0);
  pen.setStyle(styles[n / curves_.size() % styles.size()]);
  return pen;
}

}  // namespace trocar::gui
