// SPDX-License-Identifier: Apache-2.0
#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <cmath>
#include <stdexcept>

#include "framework/version.hpp"
#include "gui/figures/figure_sheet.hpp"
#include "gui/figures/result_file.hpp"

namespace trocar::gui {
namespace {

constexpr int layout_dpi = 254;  // a pixel is a tenth of a millimetre
constexpr double png_dpi = 400.0;

void write(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  if (!file.open(QFile::WriteOnly) || file.write(bytes) != bytes.size() || !file.flush())
    throw std::runtime_error(path.toStdString() + ": " + file.errorString().toStdString());
}

}  // namespace

void FigureSheet::paint(QCPPainter& painter) {
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  plot_->toPainter(&painter, plot_->viewport().width(), plot_->viewport().height());
}

void FigureSheet::save_png(const QString& path) {
  const double scale = png_dpi / layout_dpi;
  const QSizeF size = QSizeF(plot_->viewport().size()) * scale;
  QImage image(size.toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  image.setDotsPerMeterX(static_cast<int>(std::lround(png_dpi / 0.0254)));
  image.setDotsPerMeterY(image.dotsPerMeterX());
  QCPPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(scale, scale);
  paint(painter);
  painter.end();
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QBuffer::WriteOnly);
  constexpr int smallest = 0;
  image.save(&buffer, "PNG", smallest);
  write(path, bytes);
}

void FigureSheet::save_pdf(const QString& path) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QBuffer::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setResolution(layout_dpi);
  writer.setCreator("trocar " + QString::fromStdString(version()));
  writer.setPageSize(
      QPageSize(QSizeF(width_mm, height_mm()), QPageSize::Millimeter, {}, QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF(0, 0, 0, 0));
  QCPPainter painter(&writer);
  paint(painter);
  painter.end();
  write(path, bytes);
}

void FigureSheet::save_svg(const QString& path) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QBuffer::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(layout_dpi);
  generator.setSize(plot_->viewport().size());
  generator.setViewBox(plot_->viewport());
  generator.setTitle("");
  generator.setDescription("trocar " + QString::fromStdString(version()));
  QCPPainter painter(&generator);
  paint(painter);
  painter.end();
  write(path, bytes);
}

void FigureSheet::save(const QString& path) {
  if (path.endsWith(".png"))
    save_png(path);
  else if (path.endsWith(".pdf"))
    save_pdf(path);
  else if (path.endsWith(".svg"))
    save_svg(path);
  else
    throw FigureError(path.toStdString() + ": figures end with .png, .pdf or .svg");
}

}  // namespace trocar::gui
