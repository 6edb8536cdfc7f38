// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

#include "gui/device/device_tables.hpp"
#include "gui/device/mechanism_view.hpp"
#include "gui/operate/operator.hpp"
#include "gui/pages/cell_view.hpp"

namespace trocar::gui {

/// The device: its picture, its axes, what limits it, and the forces at its sites.
class DevicePage : public Page {
  Q_OBJECT

 public:
  explicit DevicePage(Operator& operators, QWidget* parent = nullptr);

  QString title() const override { return "Device"; }
  QKeySequence shortcut() const override { return QKeySequence("Ctrl+6"); }
  void refresh() override;
  void set_theme(const Theme& theme) override;
  MechanismView& picture() { return *picture_; }

 private:
  void build();
  void read_graph();

  Sources sources_;
  CellTable joints_{joint_header()}, ranges_{range_header()}, sites_{site_header()};
  JointSignals signals_;
  MechanismView* picture_;
  CellView *joint_table_, *range_table_, *site_table_;
};

}  // namespace trocar::gui
