// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QSet>
#include <QWidget>
#include <algorithm>

namespace trocar::test {

/// What a widget looks like. Kept for a person to look at, as NAME.png, in the folder that the
/// environment variable TROCAR_PICTURES names.
inline QImage picture_of(QWidget& widget, const QString& name = {}) {
  const QImage image = widget.grab().toImage();
  const QString folder = qEnvironmentVariable("TROCAR_PICTURES");
  if (!name.isEmpty() && !folder.isEmpty()) image.save(folder + "/" + name + ".png");
  return image;
}

/// How many pixels of the window's border have its colour without a gap, at most, along the top: a
/// pattern is told apart by it, also by who sees no colours.
inline int longest_dash(QWidget& window, const QColor& colour) {
  const QImage image = window.grab().toImage();
  int longest = 0, run = 0;
  for (int x = 20; x < image.width() - 20; ++x) {
    run = image.pixelColor(x, 1) == colour ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  return longest;
}

/// How many colours are in it: an empty widget has a few.
inline int colours_in(const QImage& image) {
  QSet<QRgb> colours;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) colours.insert(image.pixel(x, y));
  return static_cast<int>(colours.size());
}

}  // namespace trocar::test
