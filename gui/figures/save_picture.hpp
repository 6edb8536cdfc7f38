// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <functional>

#include "gui/plots/custom_plot.hpp"

namespace trocar::gui {

/// Whether the file's ending is that of a picture: .png, .pdf or .svg.
bool is_picture_name(const QString& path);

/// Writes what `paint` draws, on white, by the file's ending: .png (400 dpi), .pdf or .svg. Lines
/// stay lines in the last two. The same drawing gives the same bytes, but for the date in a PDF.
/// @param size of the drawing [pixels], @param dpi of them an inch
/// @throw std::runtime_error when it cannot be written, std::invalid_argument for another ending
void save_picture(const QString& path, const QSize& size, int dpi,
                  const std::function<void(QCPPainter&)>& paint);

}  // namespace trocar::gui
