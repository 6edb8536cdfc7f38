// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>
#include <QSlider>
#include <QWidget>

#include "gui/operate/parameters.hpp"
#include "gui/theme/theme.hpp"
#include "gui/window/readout.hpp"

namespace trocar::gui {

/// A parameter to be moved: slider, number with its unit, range, and what became of the last edit.
class ParameterRow : public QWidget {
  Q_OBJECT

 public:
  ParameterRow(ParameterModel& model, const QString& name, QWidget* parent = nullptr);
  const QString& name() const { return name_; }
  void set_theme(const Theme& theme);

 private:
  void build();
  void show_model();
  void show_value(const ParameterView& view);
  void ask(double value);
  void move_slider(int step);

  ParameterModel& model_;
  QString name_;
  Readout *label_, *range_, *state_;
  QSlider* slider_;
  QDoubleSpinBox* number_;
  int gesture_ = 0;  // while the slider is drawn
  Theme theme_ = Theme::light();
};

}  // namespace trocar::gui
