// SPDX-License-Identifier: Apache-2.0
#include "gui/playback/playback_bar.hpp"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace trocar::gui {

PlaybackBar::PlaybackBar(DataStore& store, LogFeed& feed, PlaybackClock& clock, QWidget* parent)
    : QWidget(parent), feed_(feed), clock_(clock), line_(new TimeLine(store, feed, clock)) {
  setObjectName("playback_bar");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 2, 8, 4);
  column->setSpacing(2);
  column->addWidget(line_);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  column->addLayout(row);
  add_moves(*row);
  add_speeds(*row);
  add_loop(*row);
  row->addStretch(1);
  add_state(*row);
  problem_ = new QLabel;
  problem_->setObjectName("playback_problem");
  problem_->setAccessibleName(tr("What is wrong with the log"));
  problem_->setWordWrap(true);
  column->addWidget(problem_);
  connect(&clock_, &PlaybackClock::moved, this, &PlaybackBar::follow_clock);
  connect(&clock_, &PlaybackClock::changed, this, &PlaybackBar::follow_clock);
  connect(&feed_, &LogFeed::opened, this, &PlaybackBar::follow_log);
  connect(&feed_, &LogFeed::advanced, this, &PlaybackBar::follow_log);
  follow_log();
  follow_clock();
}

QPushButton* PlaybackBar::add_button(QLayout& row, const char* name, const QString& text,
                                     const QString& accessible) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setAccessibleName(accessible);
  button->setToolTip(accessible);
  button->setAutoDefault(false);
  row.addWidget(button);
  return button;
}

void PlaybackBar::add_moves(QLayout& row) {
  const auto move = [&](const char* name, const QString& text, const QString& accessible, auto go) {
    connect(add_button(row, name, text, accessible), &QPushButton::clicked, this, go);
  };
  move("playback_event_before", tr("◂ event"), tr("To the marked event before"),
       [this] { clock_.jump_to_event(-1); });
  move("playback_back", tr("◂ tick"), tr("A tick back"), [this] { clock_.step(-1); });
  play_ = add_button(row, "playback_play", tr("Play"), tr("Play the log"));
  play_->setMinimumWidth(play_->fontMetrics().horizontalAdvance(tr("Hold")) + 40);
  connect(play_, &QPushButton::clicked, &clock_, &PlaybackClock::toggle);
  move("playback_forward", tr("tick ▸"), tr("A tick forward"), [this] { clock_.step(1); });
  move("playback_event_after", tr("event ▸"), tr("To the marked event after"),
       [this] { clock_.jump_to_event(1); });
  now_ = new QLabel;
  now_->setObjectName("playback_now");
  now_->setAccessibleName(tr("Time in the run"));
  now_->setMinimumWidth(now_->fontMetrics().horizontalAdvance("00000.0000 s"));
  now_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row.addWidget(now_);
}

void PlaybackBar::add_speeds(QLayout& row) {
  speed_ = new QComboBox;
  speed_->setObjectName("playback_speed");
  speed_->setAccessibleName(tr("Speed of playback"));
  for (const double speed : PlaybackClock::speeds) speed_->addItem(tr("× %1").arg(speed), speed);
  connect(speed_, &QComboBox::activated, this,
          [this](int index) { clock_.set_speed(speed_->itemData(index).toDouble()); });
  row.addWidget(speed_);
}

void PlaybackBar::add_loop(QLayout& row) {
  connect(add_button(row, "playback_loop_from", tr("Loop from"), tr("The loop begins here")),
          &QPushButton::clicked, this, [this] { mark_loop(true); });
  connect(add_button(row, "playback_loop_to", tr("to"), tr("The loop ends here")),
          &QPushButton::clicked, this, [this] { mark_loop(false); });
  no_loop_ = add_button(row, "playback_no_loop", tr("no loop"), tr("Play without a loop"));
  connect(no_loop_, &QPushButton::clicked, this, [this] { clock_.set_loop(std::nullopt); });
}

void PlaybackBar::mark_loop(bool begin) {
  LogFeed::Span span = clock_.loop().value_or(feed_.whole());
  (begin ? span.from : span.to) = clock_.now();
  if (span.to <= span.from)
    (begin ? span.to : span.from) = begin ? feed_.whole().to : feed_.whole().from;
  clock_.set_loop(span);
}

void PlaybackBar::add_state(QLayout& row) {
  run_ = new QComboBox;
  run_->setObjectName("playback_run");
  run_->setAccessibleName(tr("Run of the log"));
  connect(run_, &QComboBox::activated, this,
          [this](int index) { feed_.choose(run_->itemData(index).toInt()); });
  row.addWidget(run_);
  summary_ = new QLabel;
  summary_->setObjectName("playback_summary");
  summary_->setAccessibleName(tr("What of the log is loaded"));
  row.addWidget(summary_);
  cancel_ = add_button(row, "playback_cancel", tr("Cancel"), tr("Load no more of the log"));
  connect(cancel_, &QPushButton::clicked, &feed_, &LogFeed::cancel);
}

void PlaybackBar::set_theme(const Theme& theme) {
  line_->set_theme(theme);
  QPalette palette = problem_->palette();
  palette.setColor(QPalette::WindowText, theme.danger);
  problem_->setPalette(palette);
}

void PlaybackBar::follow_clock() {
  play_->setText(clock_.is_playing() ? tr("Hold") : tr("Play"));
  play_->setAccessibleName(clock_.is_playing() ? tr("Hold playback") : tr("Play the log"));
  now_->setText(tr("%1 s").arg(clock_.now(), 0, 'f', 4));
  const QSignalBlocker silent(speed_);
  speed_->setCurrentIndex(speed_->findData(clock_.speed()));
  no_loop_->setEnabled(clock_.loop().has_value());
}

void PlaybackBar::follow_log() {
  const QSignalBlocker silent(run_);
  run_->clear();
  for (const LogRun& run : feed_.runs())
    run_->addItem(tr("run %1, %2 s").arg(run.number).arg(run.duration(), 0, 'f', 1), run.number);
  run_->setCurrentIndex(run_->findData(feed_.run()));
  run_->setVisible(feed_.runs().size() > 1);
  summary_->setText(QString::fromStdString(feed_.summary()));
  cancel_->setVisible(feed_.state() == LogFeed::State::loading);
  problem_->setVisible(!feed_.problem().empty());
  problem_->setText(tr("⚠ The log is damaged: %1").arg(QString::fromStdString(feed_.problem())));
}

}  // namespace trocar::gui
