// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gui/window/main_window.hpp"

namespace trocar::gui {

/// All pages of the window, in the order of their tabs.
void add_pages(MainWindow& window, Operator& operators);

}  // namespace trocar::gui
