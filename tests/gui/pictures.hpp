// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QSet>
#include <QWidget>

namespace trocar::test {

/// What a widget looks like. Kept for a person to look at, as NAME.png, in the folder that the
/// environment variable TROCAR_PICTURES names.
inline QImage picture_of(QWidget& widget, const QString& name = {}) {
  const QImage image = widget.grab().toImage();
  const QString folder = qEnvironmentVariable("TROCAR_PICTURES");
  if (!name.isEmpty() && !folder.isEmpty()) image.save(folder + "/" + name + ".png");
  return image;
}

/// How many colours are in it: an empty widget has a few.
inline int colours_in(const QImage& image) {
  QSet<QRgb> colours;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) colours.insert(image.pixel(x, y));
  return static_cast<int>(colours.size());
}

}  // namespace trocar::test
