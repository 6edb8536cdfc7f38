// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/parameter_row.hpp"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace trocar::gui {
namespace {

constexpr int slider_steps = 1000;
constexpr double unbounded = 1e12;  // what a spin box takes for no bound

}  // namespace

ParameterRow::ParameterRow(ParameterModel& model, const QString& name, QWidget* parent)
    : QWidget(parent),
      model_(model),
      name_(name),
      label_(new QLabel(name, this)),
      range_(new QLabel(this)),
      state_(new QLabel(this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      number_(new QDoubleSpinBox(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 1, 6, 1);
  for (QWidget* each : std::initializer_list<QWidget*>{label_, slider_, number_, range_, state_})
    layout->addWidget(each);
  layout->setStretch(1, 1);
  label_->setMinimumWidth(150);
  state_->setMinimumWidth(170);
  slider_->setRange(0, slider_steps);
  slider_->setObjectName(name + ".slider");
  slider_->setAccessibleName(name);
  number_->setObjectName(name + ".number");
  number_->setAccessibleName(name);
  number_->setKeyboardTracking(false);  // not while somebody types
  number_->setDecimals(4);
  connect(slider_, &QSlider::valueChanged, this, [this](int step) {
    const auto row = model_.find(name_);
    if (!row) return;
    const ParameterView& view = model_.parameters()[static_cast<std::size_t>(*row)];
    ask(view.min + (view.max - view.min) * step / slider_steps);
  });
  connect(number_, &QDoubleSpinBox::valueChanged, this, &ParameterRow::ask);
  connect(&model_, &ParameterModel::dataChanged, this, &ParameterRow::show_model);
  connect(&model_, &ParameterModel::modelReset, this, &ParameterRow::show_model);
  show_model();
}

void ParameterRow::ask(double value) {
  const auto row = model_.find(name_);
  if (!row) return;
  const QString trouble = model_.ask(*row, value);
  if (trouble.isEmpty()) return;
  state_->setText(trouble);
  show_model();
}

void ParameterRow::show_model() {
  const auto row = model_.find(name_);
  setEnabled(row.has_value() && model_.may_write());
  if (!row) return;
  const ParameterView& view = model_.parameters()[static_cast<std::size_t>(*row)];
  label_->setToolTip(view.doc);
  label_->setText(name_ + (view.changed() ? " *" : ""));
  // What people are moving follows their hand, not what came back.
  const double value = view.edit == ParameterView::Edit::asked ? view.asked : view.value;
  const QSignalBlocker quiet_slider(slider_), quiet_number(number_);
  slider_->setVisible(view.bounded());
  if (view.bounded() && !slider_->isSliderDown())
    slider_->setValue(
        static_cast<int>(std::lround(slider_steps * (value - view.min) / (view.max - view.min))));
  number_->setRange(std::isfinite(view.min) ? view.min : -unbounded,
                    std::isfinite(view.max) ? view.max : unbounded);
  number_->setSuffix(view.unit.isEmpty() ? QString() : " " + view.unit);
  number_->setSingleStep(view.bounded() ? (view.max - view.min) / 100 : 1.0);
  if (!number_->hasFocus() || view.edit != ParameterView::Edit::asked) number_->setValue(value);
  range_->setText(view.range_text() + (view.unit.isEmpty() ? "" : " " + view.unit));
  state_->setText(view.edit_text());
}

void ParameterRow::set_theme(const Theme& theme) {
  theme_ = theme;
  range_->setStyleSheet(QString("color:%1;").arg(theme.muted.name()));
  state_->setStyleSheet(QString("color:%1;").arg(theme.accent.name()));
}

}  // namespace trocar::gui
