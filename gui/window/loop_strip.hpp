// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gui/operate/run_status.hpp"
#include "gui/window/readout.hpp"

namespace trocar::gui {

/// The health of the loop and of the device's reports, always in sight at the bottom.
class LoopStrip : public Readout {
  Q_OBJECT

 public:
  explicit LoopStrip(QWidget* parent = nullptr);
  void refresh(const RunStatus& status, const Theme& theme);
  static QString text(const RunStatus& status);
};

}  // namespace trocar::gui
