// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/trigger_bar.hpp"

#include <QHBoxLayout>

#include "gui/analysis/plot_layout.hpp"
#include "gui/data/shown_number.hpp"

namespace trocar::gui {
namespace {

constexpr double huge = 1e9;
constexpr int number_width = 92;
/// Of trigger_whens.
constexpr std::array whens_shown = {"rises to", "falls to", "crosses", "is above", "is below"};
static_assert(whens_shown.size() == trigger_whens.size());

}  // namespace

TriggerBar::TriggerBar(const DataStore& store, QWidget* parent)
    : QWidget(parent),
      data_(store),
      signal_(choice("trigger_signal", "signal that triggers")),
      when_(choice("trigger_when", "when it triggers")),
      mode_(choice("trigger_mode", "mode of the trigger")),
      level_(number("trigger_level", "level of the trigger", -huge, huge)),
      hysteresis_(number("trigger_hysteresis", "hysteresis of the trigger", 0.0, huge)),
      before_(number("trigger_before", "time shown before the trigger", 0.0, greatest_span)),
      after_(number("trigger_after", "time shown after the trigger", least_span, greatest_span)),
      arm_(new QPushButton("Arm", this)),
      state_(new QLabel(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  for (const char* when : whens_shown) when_->addItem(when);
  for (const char* mode : trigger_modes) mode_->addItem(mode);
  signal_->setMinimumContentsLength(18);
  signal_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  arm_->setObjectName("trigger_arm");
  arm_->setAccessibleName("arm the trigger");
  arm_->setMaximumWidth(56);
  for (QDoubleSpinBox* time : {before_, after_}) time->setSuffix(" s");
  hysteresis_->setPrefix("± ");
  level_->setDecimals(3);
  hysteresis_->setDecimals(3);
  layout->addWidget(new QLabel("When", this));
  for (QWidget* widget : std::initializer_list<QWidget*>{signal_, when_, level_, hysteresis_})
    layout->addWidget(widget);
  layout->addWidget(new QLabel("show", this));
  layout->addWidget(before_);
  layout->addWidget(new QLabel("before,", this));
  layout->addWidget(after_);
  layout->addWidget(new QLabel("after", this));
  layout->addWidget(mode_);
  layout->addWidget(arm_);
  state_->setObjectName("trigger_state");
  state_->setMinimumWidth(fontMetrics().horizontalAdvance("armed 0000"));
  layout->addWidget(state_, 1);
  connect(arm_, &QPushButton::clicked, this, &TriggerBar::arm);
  connect(signal_, &QComboBox::currentTextChanged, this, &TriggerBar::show_unit);
  show_settings({});
}

QComboBox* TriggerBar::choice(const char* name, const QString& what) {
  auto* made = new QComboBox(this);
  made->setObjectName(name);
  made->setAccessibleName(what);
  made->setToolTip(what);
  connect(made, &QComboBox::currentTextChanged, this, [this] {
    if (!showing_) Q_EMIT changed();
  });
  return made;
}

QDoubleSpinBox* TriggerBar::number(const char* name, const QString& what, double low, double high) {
  auto* made = new QDoubleSpinBox(this);
  made->setObjectName(name);
  made->setAccessibleName(what);
  made->setToolTip(what);
  made->setRange(low, high);
  made->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  made->setKeyboardTracking(false);
  made->setFixedWidth(number_width);
  connect(made, &QDoubleSpinBox::valueChanged, this, [this] {
    if (!showing_) Q_EMIT changed();
  });
  return made;
}

double TriggerBar::scale() const {
  const auto signal = data_.find(signal_->currentText().toStdString());
  return signal ? shown_scale(signal->info().unit) : 1.0;
}

void TriggerBar::show_unit() {
  const auto signal = data_.find(signal_->currentText().toStdString());
  const QString unit = signal ? shown_unit(signal->info().unit) : QString();
  for (QDoubleSpinBox* value : {level_, hysteresis_})
    value->setSuffix(unit.isEmpty() ? QString() : " " + unit);
}

void TriggerBar::show_names(const std::vector<std::string>& names) {
  QStringList all;
  for (const std::string& name : names) all << QString::fromStdString(name);
  const QString chosen = signal_->currentText();
  if (!chosen.isEmpty() && !all.contains(chosen)) all << chosen;
  showing_ = true;
  signal_->clear();
  signal_->addItems(all);
  if (!chosen.isEmpty()) signal_->setCurrentText(chosen);
  showing_ = false;
  show_unit();
}

void TriggerBar::show_settings(const TriggerSettings& settings) {
  showing_ = true;
  const QString signal = QString::fromStdString(settings.signal);
  if (!signal.isEmpty() && signal_->findText(signal) < 0) signal_->addItem(signal);
  if (!signal.isEmpty()) signal_->setCurrentText(signal);
  when_->setCurrentIndex(static_cast<int>(settings.when));
  mode_->setCurrentIndex(static_cast<int>(settings.mode));
  level_->setValue(settings.level * scale());
  hysteresis_->setValue(settings.hysteresis * scale());
  before_->setValue(settings.before);
  after_->setValue(settings.after);
  showing_ = false;
  show_unit();
}

TriggerSettings TriggerBar::settings() const {
  return {.signal = signal_->currentText().toStdString(),
          .when = static_cast<TriggerSettings::When>(when_->currentIndex()),
          .mode = static_cast<TriggerSettings::Mode>(mode_->currentIndex()),
          .level = level_->value() / scale(),
          .hysteresis = hysteresis_->value() / scale(),
          .before = before_->value(),
          .after = after_->value()};
}

void TriggerBar::show_state(const Trigger& trigger) {
  const auto show = [this](const QString& shown, const QString& whole) {
    if (shown == state_->text()) return;
    state_->setText(shown);
    state_->setToolTip(whole);
  };
  const QString count = QString::number(trigger.count());
  switch (trigger.state()) {
    case Trigger::State::off:
      return show("off", "the trigger is off; Arm looks for the next");
    case Trigger::State::armed:
      return show("armed " + count, "armed; seen since: " + count);
    case Trigger::State::filling:
      return show("filling", "triggered; the time after it is not all there yet");
    case Trigger::State::held:
      return show("held", "the first is held; Arm looks for the next");
  }
}

}  // namespace trocar::gui
