// SPDX-License-Identifier: Apache-2.0
#include "gui/figures/figure_sheet.hpp"

#include <array>
#include <cmath>

#include "gui/figures/result_file.hpp"
#include "gui/figures/save_picture.hpp"

namespace trocar::gui {
namespace {

constexpr double pixels_per_mm = 10.0;
constexpr int layout_dpi = 254;
constexpr double point_mm = 25.4 / 72.0;

constexpr int pixels(double mm) {
  return static_cast<int>(mm * pixels_per_mm + 0.5);
}

/// Writes a minus where others write a hyphen.
class MinusTicker final : public QCPAxisTicker {
 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    return QCPAxisTicker::getTickLabel(tick, locale, format, precision).replace('-', QChar(0x2212));
  }
};

void style(QCPAxis& axis, const QString& label) {
  axis.setTicker(QSharedPointer<MinusTicker>::create());
  axis.setLabel(label);
  axis.setLabelFont(FigureSheet::font());
  axis.setTickLabelFont(FigureSheet::font());
  axis.setBasePen(FigureSheet::line(0.2));
  axis.setTickPen(FigureSheet::line(0.2));
  axis.setSubTickPen(FigureSheet::line(0.15));
  axis.setTickLength(pixels(0.9));
  axis.setSubTickLength(pixels(0.5));
  axis.setTickLabelPadding(pixels(0.7));
  axis.setLabelPadding(pixels(0.6));
  axis.grid()->setVisible(false);
  axis.ticker()->setTickCount(5);
}

}  // namespace

FigureSheet::FigureSheet(double height) : plot_(std::make_unique<QCustomPlot>()) {
  plot_->setBufferDevicePixelRatio(1.0);
  plot_->resize(pixels(width_mm), pixels(height));
  plot_->setViewport(QRect(0, 0, pixels(width_mm), pixels(height)));
  plot_->setBackground(Qt::white);
  plot_->setNoAntialiasingOnDrag(false);
  plot_->setAntialiasedElements(QCP::aeAll);
  plot_->plotLayout()->clear();
  plot_->setAutoAddPlottableToLegend(false);
  plot_->plotLayout()->setMargins(QMargins(pixels(0.5), pixels(1.0), pixels(1.5), pixels(0.5)));
  plot_->plotLayout()->setRowSpacing(pixels(1.5));
  sides_ = new QCPMarginGroup(plot_.get());
}

double FigureSheet::height_mm() const {
  return plot_->viewport().height() / pixels_per_mm;
}

QCPAxisRect* FigureSheet::make_panel(const QString& x_label, const QString& y_label) {
  auto* panel = new QCPAxisRect(plot_.get());
  panel->setupFullAxesBox(true);
  panel->setMinimumMargins(QMargins(0, 0, 0, 0));
  for (const QCPAxis::AxisType type :
       {QCPAxis::atLeft, QCPAxis::atBottom, QCPAxis::atRight, QCPAxis::atTop}) {
    const bool named = type == QCPAxis::atLeft || type == QCPAxis::atBottom;
    style(*panel->axis(type), !named ? QString() : type == QCPAxis::atLeft ? y_label : x_label);
    panel->axis(type)->setTickLabels(named);
  }
  return panel;
}

QCPAxisRect& FigureSheet::add_panel(const QString& x_label, const QString& y_label, double share) {
  QCPAxisRect* panel = make_panel(x_label, y_label);
  panel->setMarginGroup(QCP::msLeft | QCP::msRight, sides_);
  row_ = new QCPLayoutGrid;
  row_->setColumnSpacing(pixels(2.0));
  row_->addElement(0, 0, panel);
  const int row = plot_->plotLayout()->rowCount();
  plot_->plotLayout()->addElement(row, 0, row_);
  plot_->plotLayout()->setRowStretchFactor(row, share);
  return *panel;
}

QCPAxisRect& FigureSheet::add_panel_beside(const QString& x_label, const QString& y_label) {
  QCPAxisRect* panel = make_panel(x_label, y_label);
  row_->addElement(0, row_->columnCount(), panel);
  return *panel;
}

void FigureSheet::share_x_axis(QCPAxisRect& panel) {
  panel.axis(QCPAxis::atBottom)->setTickLabels(false);
  panel.axis(QCPAxis::atBottom)->setLabel({});
}

QCPGraph& FigureSheet::add_curve(QCPAxisRect& panel) {
  QCPGraph* graph = plot_->addGraph(panel.axis(QCPAxis::atBottom), panel.axis(QCPAxis::atLeft));
  graph->setName({});
  return *graph;
}

QCPItemLine& FigureSheet::add_line(QCPAxisRect& panel) {
  auto* line = new QCPItemLine(plot_.get());
  line->setClipAxisRect(&panel);
  for (QCPItemPosition* end : {line->start, line->end}) {
    end->setAxisRect(&panel);
    end->setAxes(panel.axis(QCPAxis::atBottom), panel.axis(QCPAxis::atLeft));
  }
  line->setPen(FigureSheet::line(0.15));
  return *line;
}

void FigureSheet::add_legend(QCPAxisRect& panel, Qt::Alignment corner) {
  auto* legend = new QCPLegend;
  panel.insetLayout()->addElement(legend, corner);
  panel.insetLayout()->setMargins(QMargins(pixels(1), pixels(1), pixels(1), pixels(1)));
  legend->setLayer("legend");
  legend->setFont(font(6.0));
  legend->setBorderPen(Qt::NoPen);
  legend->setBrush(QColor(255, 255, 255, 215));
  legend->setMargins(QMargins(pixels(0.5), pixels(0.3), pixels(0.5), pixels(0.3)));
  legend->setIconSize(pixels(5), pixels(2));
  legend->setIconTextPadding(pixels(1));
  legend->setRowSpacing(0);
  for (QCPGraph* graph : panel.graphs())
    if (!graph->name().isEmpty()) graph->addToLegend(legend);
}

QFont FigureSheet::font(double points) {
  // Of one name on every machine, so that what was laid out fits where it is shown.
  QFont font("DejaVu Sans");
  font.setPixelSize(pixels(points * point_mm));
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

QPen FigureSheet::line(double width, Qt::PenStyle style, const QColor& colour) {
  return {QBrush(colour), width * pixels_per_mm, style, Qt::FlatCap, Qt::RoundJoin};
}

QPen FigureSheet::curve(std::size_t n) {
  // Of Okabe and Ito's colours those whose brightness differs most.
  static const std::array colours = {QColor("#000000"), QColor("#d55e00"), QColor("#0072b2"),
                                     QColor("#009e73"), QColor("#cc79a7"), QColor("#56b4e9")};
  static constexpr std::array styles = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
  return line(0.3, styles[n % styles.size()], colours[n % colours.size()]);
}

QCPScatterStyle FigureSheet::mark(std::size_t n) {
  static constexpr std::array shapes = {QCPScatterStyle::ssCircle,   QCPScatterStyle::ssSquare,
                                        QCPScatterStyle::ssTriangle, QCPScatterStyle::ssDiamond,
                                        QCPScatterStyle::ssCross,    QCPScatterStyle::ssPlus};
  QPen pen = curve(n);
  pen.setStyle(Qt::SolidLine);
  pen.setWidthF(0.2 * pixels_per_mm);
  QCPScatterStyle style(shapes[n % shapes.size()], 1.5 * pixels_per_mm);
  style.setPen(pen);
  return style;
}

void FigureSheet::save(const QString& path) {
  if (!is_picture_name(path))
    throw FigureError(path.toStdString() + ": figures end with .png, .pdf or .svg");
  save_picture(path, plot_->viewport().size(), layout_dpi, [this](QCPPainter& painter) {
    plot_->toPainter(&painter, plot_->viewport().width(), plot_->viewport().height());
  });
}

}  // namespace trocar::gui
