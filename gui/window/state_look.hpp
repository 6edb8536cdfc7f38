// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>

#include "gui/operate/run_status.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// How states look: a word of their own, a shape for those who do not see the colour, a colour.
const char* shape_of(RunState state);
QColor colour_of(RunState state, const Theme& theme);
QColor colour_of(Mode mode, const Theme& theme);
Qt::PenStyle border_of(Mode mode);

}  // namespace trocar::gui
