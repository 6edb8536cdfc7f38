// SPDX-License-Identifier: Apache-2.0
#include "gui/analysis/trigger.hpp"

#include <algorithm>

namespace trocar::gui {
namespace {

constexpr double least_patience = 0.5;  // [s]

}  // namespace

void Trigger::arm(const DataStore& data, const TriggerSettings& settings) {
  settings_ = settings;
  state_ = State::armed;
  shot_.reset();
  count_ = 0;
  track_ = nullptr;
  if (const auto signal = data.find(settings_.signal)) begin_at(*signal);
}

void Trigger::disarm() {
  state_ = State::off;
  shot_.reset();
}

void Trigger::begin_at(const SignalRef& signal) {
  track_ = signal.track;
  next_ = signal.track->view_end();
  was_below_ = was_above_ = false;
  // An edge needs to know where it came from.
  if (next_ > signal.track->first()) fires(signal.column()[next_ - 1]);
}

/// How long automatic waits before the picture runs again.
double Trigger::patience() const {
  return std::max(least_patience, 2.0 * (settings_.before + settings_.after));
}

bool Trigger::fires(double value) {
  using When = TriggerSettings::When;
  const double level = settings_.level, hysteresis = settings_.hysteresis;
  const bool rose = was_below_ && value >= level, fell = was_above_ && value <= level;
  if (rose) was_below_ = false;
  if (fell) was_above_ = false;
  if (value < level && value <= level - hysteresis) was_below_ = true;
  if (value > level && value >= level + hysteresis) was_above_ = true;
  switch (settings_.when) {
    case When::rises:
      return rose;
    case When::falls:
      return fell;
    case When::crosses:
      return rose || fell;
    case When::above:
      return value > level;
    case When::below:
      return value < level;
  }
  return false;
}

bool Trigger::look(const SignalRef& signal, std::uint64_t end) {
  const Track& track = *signal.track;
  next_ = std::max(next_, track.first());
  while (next_ < end) {
    const std::uint64_t row = next_++;
    if (fires(signal.column()[row])) {
      found_ = track.time(row);
      return true;
    }
  }
  return false;
}

bool Trigger::search(const DataStore& data) {
  if (state_ == State::off) return false;
  const auto signal = data.find(settings_.signal);
  if (!signal || signal->track->empty()) return false;
  const Track& track = *signal->track;
  const std::uint64_t end = track.view_end();
  const bool elsewhere = track_ != &track || next_ > end;  // another run, or playback went back
  if (elsewhere) {
    const bool had = shot_.has_value();
    arm(data, settings_);
    return had;
  }
  if (end == track.first()) return false;
  const double now = track.time(end - 1);
  bool changed = false;
  for (;;) {
    if (state_ == State::armed && look(*signal, end)) state_ = State::filling;
    if (state_ != State::filling || now < found_ + settings_.after) break;
    shot_ = Shot{found_, settings_.before, settings_.after};
    ++count_;
    changed = true;
    if (settings_.mode == TriggerSettings::Mode::single) {
      state_ = State::held;
      break;
    }
    // What is shown already does not trigger again, but tells from which side an edge comes.
    const std::uint64_t behind = track.at(found_ + settings_.after);
    while (next_ < behind) fires(signal->column()[next_++]);
    state_ = State::armed;
  }
  if (settings_.mode == TriggerSettings::Mode::automatic && shot_ && state_ == State::armed &&
      now - shot_->at - shot_->after > patience()) {
    shot_.reset();
    changed = true;
  }
  return changed;
}

}  // namespace trocar::gui
