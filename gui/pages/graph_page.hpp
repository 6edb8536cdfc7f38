// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

#include "gui/graph/graph_view.hpp"
#include "gui/operate/operator.hpp"
#include "gui/pages/cell_view.hpp"

namespace trocar::gui {

/// The graph that runs, and the ports of the component that is chosen in it with their values.
class GraphPage : public Page {
  Q_OBJECT

 public:
  explicit GraphPage(Operator& operators, QWidget* parent = nullptr);

  QString title() const override { return "Graph"; }
  QKeySequence shortcut() const override { return QKeySequence("Ctrl+7"); }
  void refresh() override;
  void set_theme(const Theme& theme) override;
  GraphView& view() { return *view_; }

 private:
  void build();
  void show_ports();

  GraphModel model_;
  CellTable ports_{GraphModel::port_header()};
  GraphView* view_;
  QLabel *name_, *state_, *legend_;
  CellView* port_table_;
};

}  // namespace trocar::gui
