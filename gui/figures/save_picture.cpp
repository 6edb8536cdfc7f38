// SPDX-License-Identifier: Apache-2.0
#include "gui/figures/save_picture.hpp"

#include <QBuffer>
#include <QImage>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>
#include <cmath>
#include <stdexcept>

#include "framework/version.hpp"

namespace trocar::gui {
namespace {

constexpr double png_dpi = 400.0;
constexpr double mm_an_inch = 25.4;

using Paint = std::function<void(QCPPainter&)>;

void paint_lines(QPaintDevice& device, const Paint& paint) {
  QCPPainter painter;
  painter.begin(&device);
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  paint(painter);
  painter.end();
}

void write_png(QBuffer& buffer, const QSize& size, int dpi, const Paint& paint) {
  const double scale = png_dpi / dpi;
  QImage image((QSizeF(size) * scale).toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  image.setDotsPerMeterX(static_cast<int>(std::lround(1e3 * png_dpi / mm_an_inch)));
  image.setDotsPerMeterY(image.dotsPerMeterX());
  paint_lines(image, [&](QCPPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale, scale);
    paint(painter);
  });
  constexpr int smallest = 0;
  image.save(&buffer, "PNG", smallest);
}

void write_pdf(QBuffer& buffer, const QSize& size, int dpi, const Paint& paint) {
  QPdfWriter writer(&buffer);
  writer.setResolution(dpi);
  writer.setCreator("trocar " + QString::fromStdString(version()));
  writer.setPageSize(
      QPageSize(QSizeF(size) * mm_an_inch / dpi, QPageSize::Millimeter, {}, QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF(0, 0, 0, 0));
  paint_lines(writer, paint);
}

void write_svg(QBuffer& buffer, const QSize& size, int dpi, const Paint& paint) {
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(dpi);
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(), size));
  generator.setTitle("");
  generator.setDescription("trocar " + QString::fromStdString(version()));
  paint_lines(generator, paint);
}

}  // namespace

bool is_picture_name(const QString& path) {
  return path.endsWith(".png") || path.endsWith(".pdf") || path.endsWith(".svg");
}

void save_picture(const QString& path, const QSize& size, int dpi, const Paint& paint) {
  if (!is_picture_name(path))
    throw std::invalid_argument(path.toStdString() + ": pictures end with .png, .pdf or .svg");
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QBuffer::WriteOnly);
  const auto write = path.endsWith(".png")   ? write_png
                     : path.endsWith(".pdf") ? write_pdf
                                             : write_svg;
  write(buffer, size, dpi, paint);
  QSaveFile file(path);
  if (!file.open(QFile::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
    throw std::runtime_error(path.toStdString() + ": " + file.errorString().toStdString());
}

}  // namespace trocar::gui
