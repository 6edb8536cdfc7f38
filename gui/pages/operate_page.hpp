// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QVBoxLayout>
#include <vector>

#include "gui/device/mechanism_view.hpp"
#include "gui/operate/operator.hpp"
#include "gui/pages/force_meter.hpp"
#include "gui/pages/parameter_row.hpp"
#include "gui/plots/time_plot.hpp"
#include "gui/plots/xy_plot.hpp"

namespace trocar::gui {

/// The first screen: force at the handle, the device, live plots, and the parameters of the
/// fixtures.
class OperatePage : public Page {
  Q_OBJECT

 public:
  explicit OperatePage(Operator& operators, QWidget* parent = nullptr);

  QString title() const override { return "Operate"; }
  QKeySequence shortcut() const override { return QKeySequence("Ctrl+1"); }
  void refresh() override;
  void set_theme(const Theme& theme) override;
  void freeze(std::optional<double> at) override;

 private:
  void choose_signals();
  void show_cap();
  void choose_parameters();

  Operator& operator_;
  ForceMeter* meter_;
  MechanismView* picture_;
  TimePlot *force_, *tip_;
  XyPlot* over_depth_;
  QVBoxLayout* rows_;
  std::vector<ParameterRow*> parameters_;
  double cap_ = 0.0;  // [N] that is shown
  Theme theme_ = Theme::light();
};

}  // namespace trocar::gui
