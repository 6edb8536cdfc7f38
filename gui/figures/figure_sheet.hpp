// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "gui/plots/custom_plot.hpp"

namespace trocar::gui {

/// A figure as printed: a paper's column wide, in black on white, with lines and marks that are
/// told apart in grey. A pixel of the plot is a tenth of a millimetre.
class FigureSheet {
 public:
  static constexpr double width_mm = 85.0;

  /// Empty, of panels that are put one below the other. There must be a QApplication.
  /// @param height [mm]
  explicit FigureSheet(double height);

  QCustomPlot& plot() { return *plot_; }
  double height_mm() const;

  /// A new panel below the others, whose axes line up with theirs.
  /// @param share of the height, beside those of the others
  QCPAxisRect& add_panel(const QString& x_label, const QString& y_label, double share = 1.0);
  /// A panel at the right of the panel before, with frame and axes of its own.
  QCPAxisRect& add_panel_beside(const QString& x_label, const QString& y_label);
  /// Its x axis is that of the panel below: neither numbers nor label.
  static void share_x_axis(QCPAxisRect& panel);
  QCPGraph& add_curve(QCPAxisRect& panel);
  QCPItemLine& add_line(QCPAxisRect& panel);
  /// In a corner of the panel, where no curve is: the legend of what was added with a name.
  void add_legend(QCPAxisRect& panel, Qt::Alignment corner);

  static QFont font(double points = 7.0);
  /// @param width [mm]
  static QPen line(double width, Qt::PenStyle style = Qt::SolidLine,
                   const QColor& colour = Qt::black);
  /// Of the n-th curve: black first, then colours of another brightness each, with dashes.
  static QPen curve(std::size_t n);
  /// Of the n-th curve's points.
  static QCPScatterStyle mark(std::size_t n);

  /// By the file's ending: .png (400 dpi), .pdf or .svg. The same figure gives the same bytes, but
  /// for the date in a PDF.
  /// @throw std::runtime_error when it cannot be written, FigureError for another ending
  void save(const QString& path);

 private:
  QCPAxisRect* make_panel(const QString& x_label, const QString& y_label);

  std::unique_ptr<QCustomPlot> plot_;
  QCPMarginGroup* sides_;  // of the plot
  QCPLayoutGrid* row_ = nullptr;
};

}  // namespace trocar::gui
