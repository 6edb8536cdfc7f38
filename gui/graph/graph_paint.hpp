// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPainter>
#include <optional>

#include "gui/graph/graph_model.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// Paints a graph in the coordinates of its layout.
void paint_graph(QPainter& painter, const GraphModel& model, const Theme& theme,
                 std::optional<std::size_t> selected);

}  // namespace trocar::gui
