// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QWidget>

#include "gui/operate/parameters.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// A parameter to be moved: slider, number with its unit, range, and what became of the last edit.
class ParameterRow : public QWidget {
  Q_OBJECT

 public:
  ParameterRow(ParameterModel& model, const QString& name, QWidget* parent = nullptr);
  const QString& name() const { return name_; }
  void set_theme(const Theme& theme);

 private:
  void show_model();
  void ask(double value);

  ParameterModel& model_;
  QString name_;
  QLabel *label_, *range_, *state_;
  QSlider* slider_;
  QDoubleSpinBox* number_;
  Theme theme_ = Theme::light();
};

}  // namespace trocar::gui
