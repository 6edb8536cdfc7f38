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

/// The same for each row, so that they stand under each other. [pixels]
constexpr int name_width = 190, number_width = 150, range_width = 160, state_width = 240;

}  // namespace

ParameterRow::ParameterRow(ParameterModel& model, const QString& name, QWidget* parent)
    : QWidget(parent),
      model_(model),
      name_(name),
      label_(new Readout("name", "parameter", this)),
      range_(new Readout("range", "range", this)),
      state_(new Readout("edit", "last edit", this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      number_(new QDoubleSpinBox(this)) {
  build();
  connect(slider_, &QSlider::sliderPressed, this, [this] { gesture_ = model_.begin_gesture(); });
  connect(slider_, &QSlider::sliderReleased, this, [this] { gesture_ = 0; });
  connect(slider_, &QSlider::valueChanged, this, &ParameterRow::move_slider);
  connect(number_, &QDoubleSpinBox::valueChanged, this, &ParameterRow::ask);
  connect(&model_, &ParameterModel::dataChanged, this, &ParameterRow::show_model);
  connect(&model_, &ParameterModel::modelReset, this, &ParameterRow::show_model);
  show_model();
}

void ParameterRow::build() {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2, 1, 2, 1);
  for (QWidget* each : std::initializer_list<QWidget*>{label_, slider_, number_, range_, state_})
    layout->addWidget(each);
  layout->setStretch(1, 1);
  label_->setFixedWidth(name_width);
  number_->setFixedWidth(number_width);
  range_->setFixedWidth(range_width);
  state_->setFixedWidth(state_width);
  slider_->setRange(0, slider_steps);
  slider_->setObjectName(name_ + ".slider");
  slider_->setAccessibleName(name_ + ", slider");
  QSizePolicy stays = slider_->sizePolicy();
  stays.setRetainSizeWhenHidden(true);
  slider_->setSizePolicy(stays);
  number_->setObjectName(name_ + ".number");
  number_->setAccessibleName(name_);
  number_->setKeyboardTracking(false);  // not while somebody types
  number_->setDecimals(4);
}

void ParameterRow::move_slider(int step) {
  const auto row = model_.find(name_);
  if (!row) return;
  const ParameterView& view = model_.parameters()[static_cast<std::size_t>(*row)];
  ask(view.min + (view.max - view.min) * step / slider_steps);
}

void ParameterRow::ask(double value) {
  const auto row = model_.find(name_);
  if (!row) return;
  const QString trouble = model_.ask(*row, value, gesture_);
  if (trouble.isEmpty()) return;
  show_model();
  state_->show_text(trouble);
}

void ParameterRow::show_model() {
  const auto row = model_.find(name_);
  for (QWidget* each : std::initializer_list<QWidget*>{slider_, number_})
    each->setEnabled(row.has_value() && model_.may_write());
  if (!row) return;
  const ParameterView& view = model_.parameters()[static_cast<std::size_t>(*row)];
  label_->setToolTip(view.doc);
  label_->show_text(name_ + (view.changed() ? " *" : ""));
  show_value(view);
  range_->show_text(view.range_text() + (view.unit.isEmpty() ? "" : " " + view.unit));
  state_->show_text(view.edit_text());
  state_->paint_plain(view.edit == ParameterView::Edit::refused ? theme_.danger : theme_.accent);
}

/// What people are moving follows their hand, not what came back.
void ParameterRow::show_value(const ParameterView& view) {
  const bool asked = view.edit == ParameterView::Edit::asked;
  const double value = asked ? view.asked : view.value;
  const QSignalBlocker quiet_slider(slider_), quiet_number(number_);
  slider_->setVisible(view.bounded());
  if (view.bounded() && !slider_->isSliderDown())
    slider_->setValue(
        static_cast<int>(std::lround(slider_steps * (value - view.min) / (view.max - view.min))));
  number_->setRange(std::isfinite(view.min) ? view.min : -unbounded,
                    std::isfinite(view.max) ? view.max : unbounded);
  number_->setSuffix(view.unit.isEmpty() ? QString() : " " + view.unit);
  number_->setSingleStep(view.bounded() ? (view.max - view.min) / 100 : 1.0);
  if (!number_->hasFocus() || !asked) number_->setValue(value);
}

void ParameterRow::set_theme(const Theme& theme) {
  theme_ = theme;
  label_->paint_plain(theme.text);
  range_->paint_plain(theme.muted);
  show_model();
}

}  // namespace trocar::gui
