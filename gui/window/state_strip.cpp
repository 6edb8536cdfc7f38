// SPDX-License-Identifier: Apache-2.0
#include "gui/window/state_strip.hpp"

#include <QHBoxLayout>
#include <QTimer>
#include <QVBoxLayout>

#include "gui/window/state_look.hpp"

namespace trocar::gui {
namespace {

constexpr int remark_shown_ms = 8000;
constexpr QSize stop_size(250, 66);  // of all that it ever says: it must not move

}  // namespace

StateStrip::StateStrip(Operator& operators, QWidget* parent)
    : QWidget(parent),
      operator_(operators),
      mode_(new Readout("mode", "what is looked at", this)),
      state_(new Readout("state", "state of the device", this)),
      hand_(new Readout("hand", "dead-man switch", this)),
      recording_(new Readout("recording", "recording", this)),
      link_(new Readout("link", "link to the runtime", this)),
      fault_(new Readout("fault", "first fault", this)),
      remark_(new Readout("remark", "what the runtime answered", this)),
      banner_(new Readout("banner", "notice", this)) {
  build();
  connect(stop_, &QPushButton::clicked, &operator_.stop_control(), &StopControl::stop);
  connect(&operator_.stop_control(), &StopControl::changed, this, &StateStrip::show_stop);
  connect(acknowledge_, &QPushButton::clicked, this, [this] { operator_.request("acknowledge"); });
  connect(engage_, &QPushButton::clicked, this, [this] { operator_.request("engage"); });
  connect(record_, &QPushButton::clicked, this, &StateStrip::toggle_recording);
  connect(&operator_.alarms(), &AlarmModel::changed, this, &StateStrip::show_fault);
  connect(&operator_, &Operator::remark, this, &StateStrip::say);
  set_theme(theme_);
}

QPushButton* StateStrip::button(const char* name, const QString& text, const QString& help) {
  auto* made = new QPushButton(text, this);
  made->setObjectName(name);
  made->setAccessibleName(help);
  made->setToolTip(help);
  return made;
}

void StateStrip::build() {
  engage_ = button("engage", "Engage  Ctrl+E", "Ask the runtime to engage");
  record_ = button("record", "Record  Ctrl+R", "Begin or end a recording");
  acknowledge_ =
      button("acknowledge", "Acknowledge  Ctrl+K", "Acknowledge the faults whose cause is gone");
  stop_ = button("stop", "", "Software stop: ends the rendering");
  stop_->setFixedSize(stop_size);
  stop_->setFocusPolicy(Qt::NoFocus);  // a click must not take it from where somebody types

  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(6, 4, 6, 2);
  all->setSpacing(4);
  auto* top = new QHBoxLayout;
  all->addLayout(top);
  auto* rows = new QVBoxLayout;
  top->addLayout(rows, 1);
  top->addWidget(stop_, 0, Qt::AlignTop);
  auto* first = new QHBoxLayout;
  auto* second = new QHBoxLayout;
  rows->addLayout(first);
  rows->addLayout(second);
  for (Readout* each : {mode_, state_, hand_, recording_, link_}) first->addWidget(each);
  for (Readout* each : {mode_, hand_, recording_, link_}) each->set_whole();
  first->addStretch(1);
  for (QPushButton* each : {engage_, record_}) first->addWidget(each);
  second->addWidget(fault_, 3);
  second->addWidget(remark_, 2);
  second->addWidget(acknowledge_);
  remark_->hide();
  all->addWidget(banner_);
  for (Readout* each : {fault_, remark_, banner_})
    each->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void StateStrip::toggle_recording() {
  RecordingControl& recording = operator_.recording();
  recording.can_end() ? recording.stop() : recording.start();
}

void StateStrip::set_theme(const Theme& theme) {
  theme_ = theme;
  remark_->paint_plain(theme_.warning);
  show_stop();
  refresh();
}

void StateStrip::refresh() {
  show_state();
  show_link();
  show_recording();
  show_fault();
}

void StateStrip::show_state() {
  const RunStatus& status = operator_.status();
  mode_->show_text(to_string(status.mode));
  mode_->paint_sign(colour_of(status.mode, theme_), theme_.surface);
  QString words = QString("%1 %2").arg(shape_of(status.state), to_string(status.state));
  if (!status.state_note.empty()) words += ": " + QString::fromStdString(status.state_note);
  state_->show_text(words);
  state_->paint_sign(colour_of(status.state, theme_), theme_.surface);
  hand_->setVisible(status.hand.has_value());
  if (!status.hand) return;
  hand_->show_text(status.stale() ? "hand: ?" : *status.hand ? "hand: on" : "hand: OFF");
  hand_->paint_plain(status.stale() ? theme_.muted : theme_.text);
}

void StateStrip::show_link() {
  const StreamClient* link = operator_.sources().link;
  const bool open = link != nullptr && link->state() == LinkState::open;
  link_->show_text(link == nullptr ? QString("a log")
                   : open          ? QString("link %1 ms").arg(link->round_trip_ms(), 0, 'f', 0)
                                   : QString("link %1").arg(to_string(link->state())));
  link_->paint_plain(open || link == nullptr ? theme_.text : theme_.danger);
  for (QPushButton* each : {record_, engage_, acknowledge_}) {
    each->setVisible(link != nullptr);
    each->setEnabled(open && link->may_write());
  }
  if (operator_.alarms().first() == nullptr && !operator_.status().fault)
    acknowledge_->setEnabled(false);
}

void StateStrip::show_recording() {
  const RecordingControl& recording = operator_.recording();
  const bool failed = !recording.trouble().isEmpty();
  recording_->show_text(recording.text());
  if (failed)
    recording_->paint_sign(theme_.danger, theme_.on_danger);
  else
    recording_->paint_plain(recording.incomplete() ? theme_.warning : theme_.text);
  record_->setText(recording.can_end() ? "End recording  Ctrl+R" : "Record  Ctrl+R");
  banner_->setVisible(failed || !notice_.isEmpty());
  banner_->show_text(failed ? recording.failure() : notice_);
  if (failed)
    banner_->paint_sign(theme_.danger, theme_.on_danger);
  else
    banner_->paint_sign(theme_.warning, theme_.surface);
}

void StateStrip::show_stop() {
  const StopControl& stop = operator_.stop_control();
  QString said = operator_.sources().link == nullptr ? QString("a log is played: nothing to stop")
                                                     : QString::fromStdString(stop.text());
  if (!said.isEmpty()) said[0] = said[0].toUpper();
  const QString lines = QString(said).replace(": ", ":\n");
  stop_->setText("STOP  F12  (software stop)" + (lines.isEmpty() ? "" : "\n" + lines));
  stop_->setAccessibleName("Software stop: ends the rendering. " + said);
  const QColor ground =
      stop.state() == StopControl::State::confirmed ? theme_.muted : theme_.danger;
  stop_->setStyleSheet(
      QString("background:%1; color:%2; font-weight:bold; font-size:13px; border:2px solid %3;"
              "border-radius:4px; padding:2px 4px;")
          .arg(ground.name(),
               (theme_.dark && ground == theme_.muted ? theme_.window : theme_.on_danger).name(),
               theme_.text.name()));
}

void StateStrip::show_fault() {
  const Alarm* first = operator_.alarms().first();
  fault_->show_text(first == nullptr
                        ? QString("no fault")
                        : "FAULT  " + AlarmModel::text(*first, operator_.sources().data.now()));
  if (first == nullptr)
    fault_->paint_plain(theme_.muted);
  else
    fault_->paint_sign(theme_.danger, theme_.on_danger);
}

void StateStrip::set_notice(const QString& notice) {
  notice_ = notice;
  show_recording();
}

void StateStrip::say(const QString& text) {
  remark_->show_text(text);
  remark_->show();
  QTimer::singleShot(remark_shown_ms, this, [this, text] {
    if (remark_->whole_text() == text) remark_->hide();
  });
}

}  // namespace trocar::gui
