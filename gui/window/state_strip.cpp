// SPDX-License-Identifier: Apache-2.0
#include "gui/window/state_strip.hpp"

#include <QHBoxLayout>
#include <QTimer>
#include <QVBoxLayout>

namespace trocar::gui {
namespace {

constexpr int remark_shown_ms = 8000;

/// A shape beside each word, for those who do not see the colour.
const char* shape(RunState state) {
  switch (state) {
    case RunState::unknown:
      return "?";
    case RunState::engaged:
      return "▲";
    case RunState::engaging:
      return "△";
    case RunState::stopped:
      return "■";
    case RunState::holding:
      return "●";
    default:
      return "○";
  }
}

QColor colour(RunState state, const Theme& theme) {
  switch (state) {
    case RunState::engaged:
    case RunState::engaging:
      return theme.ok;
    case RunState::stopped:
    case RunState::unknown:
      return theme.danger;
    case RunState::holding:
      return theme.accent;
    default:
      return theme.muted;
  }
}

QPushButton* button(const char* name, const QString& text, const QString& help, QWidget* parent) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setAccessibleName(help);
  made->setToolTip(help);
  return made;
}

}  // namespace

StateStrip::StateStrip(Operator& operators, QWidget* parent)
    : QWidget(parent), operator_(operators) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(6, 4, 6, 4);
  rows->setSpacing(4);
  auto* top = new QHBoxLayout;
  top->setSpacing(8);
  rows->addLayout(top);
  mode_ = label("mode", "what is looked at");
  state_ = label("state", "state of the device");
  hand_ = label("hand", "hand on the device");
  recording_ = label("recording", "recording");
  link_ = label("link", "link to the runtime");
  engage_ = button("engage", "Engage  Ctrl+E", "Ask the runtime to engage", this);
  record_ = button("record", "Record  Ctrl+R", "Begin or end a recording", this);
  stop_ = button("stop", "STOP  F12", "Software stop: ends the rendering", this);
  stop_->setMinimumSize(240, 44);
  // A click must not take the focus from where somebody types.
  stop_->setFocusPolicy(Qt::NoFocus);
  for (QWidget* each :
       std::initializer_list<QWidget*>{mode_, state_, hand_, recording_, record_, engage_, link_})
    top->addWidget(each);
  top->addStretch(1);
  top->addWidget(stop_);

  auto* bottom = new QHBoxLayout;
  rows->addLayout(bottom);
  fault_ = label("fault", "first fault");
  remark_ = label("remark", "what the runtime answered");
  acknowledge_ = button("acknowledge", "Acknowledge  Ctrl+K",
                        "Acknowledge the faults whose cause is gone", this);
  bottom->addWidget(fault_, 1);
  bottom->addWidget(remark_, 1);
  bottom->addWidget(acknowledge_);

  connect(stop_, &QPushButton::clicked, &operator_.stop_control(), &StopControl::stop);
  connect(&operator_.stop_control(), &StopControl::changed, this, &StateStrip::show_stop);
  connect(acknowledge_, &QPushButton::clicked, this, [this] { operator_.request("acknowledge"); });
  connect(engage_, &QPushButton::clicked, this, [this] { operator_.request("engage"); });
  connect(record_, &QPushButton::clicked, this, [this] {
    RecordingControl& recording = operator_.recording();
    if (operator_.sources().live != nullptr &&
        !operator_.sources().live->state().recording.file.empty())
      recording.stop();
    else
      recording.start();
  });
  connect(&operator_.alarms(), &AlarmModel::changed, this, &StateStrip::show_fault);
  connect(&operator_, &Operator::remark, this, &StateStrip::say);
  set_theme(theme_);
}

QLabel* StateStrip::label(const char* name, const char* accessible) {
  auto* made = new QLabel(this);
  made->setObjectName(name);
  made->setAccessibleName(accessible);
  return made;
}

void StateStrip::paint(QLabel& label, const QColor& back, const QColor& text) {
  label.setStyleSheet(QString("background:%1; color:%2; padding:4px 10px; font-weight:bold;"
                              "font-size:15px; border-radius:3px;")
                          .arg(back.name(), text.name()));
}

void StateStrip::set_theme(const Theme& theme) {
  theme_ = theme;
  show_stop();
  show_fault();
  refresh();
}

void StateStrip::refresh() {
  const RunStatus& status = operator_.status();
  const QColor mode = status.mode == Mode::live        ? theme_.live
                      : status.mode == Mode::simulated ? theme_.simulated
                      : status.mode == Mode::replay    ? theme_.replay
                                                       : theme_.muted;
  mode_->setText(to_string(status.mode));
  paint(*mode_, mode, theme_.surface);
  QString words = QString("%1 %2").arg(shape(status.state), to_string(status.state));
  if (!status.state_note.empty()) words += ": " + QString::fromStdString(status.state_note);
  state_->setText(words);
  paint(*state_, colour(status.state, theme_), theme_.surface);
  hand_->setText(status.hand ? (*status.hand ? "hand: on" : "hand: OFF") : "");
  hand_->setVisible(status.hand.has_value());
  const RecordingControl& recording = operator_.recording();
  recording_->setText(recording.text());
  const bool failed = !recording.trouble().isEmpty();
  paint(*recording_, failed ? theme_.danger : theme_.surface,
        failed ? theme_.on_danger : theme_.text);
  const StreamClient* link = operator_.sources().link;
  if (link == nullptr)
    link_->setText("a log");
  else if (link->state() != LinkState::open)
    link_->setText(QString("link %1").arg(to_string(link->state())));
  else
    link_->setText(QString("link %1 ms").arg(link->round_trip_ms(), 0, 'f', 0));
  record_->setText(failed || recording.recording() ? "End recording  Ctrl+R" : "Record  Ctrl+R");
  for (QPushButton* each : {record_, engage_, acknowledge_})
    each->setEnabled(link != nullptr && link->state() == LinkState::open && link->may_write());
}

void StateStrip::show_stop() {
  const StopControl& stop = operator_.stop_control();
  const QString said = QString::fromStdString(stop.text());
  stop_->setText(said.isEmpty() ? "STOP  F12\n(software stop)" : said + "\nSTOP  F12");
  const QColor back = stop.state() == StopControl::State::confirmed ? theme_.muted : theme_.danger;
  stop_->setStyleSheet(QString("background:%1; color:%2; font-weight:bold; font-size:14px;"
                               "border:2px solid %3; border-radius:4px; padding:2px 10px;")
                           .arg(back.name(), theme_.on_danger.name(), theme_.text.name()));
}

void StateStrip::show_fault() {
  const Alarm* first = operator_.alarms().first();
  acknowledge_->setVisible(first != nullptr);
  fault_->setText(first == nullptr ? "no fault" : "FAULT  " + AlarmModel::text(*first));
  if (first == nullptr)
    fault_->setStyleSheet(QString("color:%1; padding:2px 4px;").arg(theme_.muted.name()));
  else
    paint(*fault_, theme_.danger, theme_.on_danger);
}

void StateStrip::say(const QString& text) {
  remark_->setText(text);
  remark_->setStyleSheet(QString("color:%1;").arg(theme_.warning.name()));
  QTimer::singleShot(remark_shown_ms, this, [this, text] {
    if (remark_->text() == text) remark_->clear();
  });
}

}  // namespace trocar::gui
