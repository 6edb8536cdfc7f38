// SPDX-License-Identifier: Apache-2.0
#include "gui/playback/playback_clock.hpp"

#include <algorithm>
#include <cmath>

namespace trocar::gui {

PlaybackClock::PlaybackClock(DataStore& store, LogFeed& feed, QObject* parent)
    : QObject(parent), store_(store), feed_(feed) {
  constexpr int frame_ms = 33;
  timer_.setInterval(frame_ms);
  connect(&timer_, &QTimer::timeout, this,
          [this] { advance(1e-3 * static_cast<double>(since_.restart())); });
  connect(&feed_, &LogFeed::opened, this, &PlaybackClock::follow_log);
  connect(&feed_, &LogFeed::advanced, this, [this] {
    if (now_ > feed_.whole().to) move(now_);
  });
}

void PlaybackClock::follow_log() {
  loop_.reset();
  hold();
  move(feed_.whole().from);
}

void PlaybackClock::play() {
  const bool at_end = now_ >= feed_.whole().to;
  if (at_end) move(loop_ ? loop_->from : feed_.whole().from);
  since_.start();
  timer_.start();
  Q_EMIT changed();
}

void PlaybackClock::hold() {
  timer_.stop();
  Q_EMIT changed();
}

void PlaybackClock::set_speed(double speed) {
  speed_ = *std::min_element(speeds.begin(), speeds.end(), [&](double a, double b) {
    return std::abs(std::log(a / speed)) < std::abs(std::log(b / speed));
  });
  Q_EMIT changed();
}

void PlaybackClock::set_loop(std::optional<LogFeed::Span> span) {
  loop_ = span && span->to > span->from ? span : std::nullopt;
  Q_EMIT changed();
}

void PlaybackClock::seek(double time) {
  move(time);
}

void PlaybackClock::move(double time) {
  now_ = std::clamp(time, feed_.whole().from, std::max(feed_.whole().from, feed_.whole().to));
  store_.set_view_end(now_);
  feed_.load_around(now_);
  Q_EMIT moved(now_);
}

void PlaybackClock::advance(double seconds) {
  double time = now_ + speed_ * seconds;
  if (loop_ && time > loop_->to) {
    const double length = loop_->to - loop_->from;
    time = loop_->from + std::fmod(std::max(0.0, time - loop_->from), length);
  } else if (feed_.state() == LogFeed::State::loading) {
    time = std::clamp(time, now_, std::max(now_, feed_.loaded().to));  // the rest is on its way
  }
  move(time);
  if (!loop_ && now_ >= feed_.whole().to && feed_.state() != LogFeed::State::loading) hold();
}

const Track* PlaybackClock::finest() const {
  const Track* finest = nullptr;
  for (const auto& track : store_.tracks())
    if (!track->empty() && (finest == nullptr || track->end() > finest->end()))
      finest = track.get();
  return finest;
}

void PlaybackClock::step(int rows) {
  hold();
  const Track* track = finest();
  if (track == nullptr) return;
  const std::uint64_t shown = std::max(track->view_end(), track->first() + 1);
  const auto steps = static_cast<std::int64_t>(rows);
  const auto newest = static_cast<std::int64_t>(track->end()) - 1;
  const std::int64_t row = std::clamp(static_cast<std::int64_t>(shown) - 1 + steps,
                                      static_cast<std::int64_t>(track->first()), newest);
  move(track->time(static_cast<std::uint64_t>(row)));
}

void PlaybackClock::jump_to_event(int direction) {
  hold();
  const RunEvent* best = nullptr;
  for (const RunEvent& event : store_.events()) {
    if (!is_marked(event)) continue;
    if (direction > 0 && event.time > now_ && (best == nullptr || event.time < best->time))
      best = &event;
    if (direction < 0 && event.time < now_ && (best == nullptr || event.time > best->time))
      best = &event;
  }
  if (best != nullptr) move(best->time);
}

}  // namespace trocar::gui
