// SPDX-License-Identifier: Apache-2.0
#include "gui/operate/stop_control.hpp"

#include <algorithm>

#include "gui/operate/rendering.hpp"

namespace trocar::gui {
namespace {

constexpr int look_interval_ms = 5;

}  // namespace

StopControl::StopControl(const Sources& sources, QObject* parent)
    : QObject(parent), sources_(sources) {
  clock_.start();
  connect(&look_, &QTimer::timeout, this, &StopControl::look);
  if (sources_.live != nullptr) connect(sources_.live, &LiveFeed::grew, this, &StopControl::look);
  connect(&sources_.data, &DataStore::event_added, this, &StopControl::hear_event);
}

std::int64_t StopControl::newest_tick() const {
  std::int64_t newest = -1;
  for (const auto& track : sources_.data.tracks())
    if (!track->empty()) newest = std::max(newest, track->tick(track->end() - 1));
  return newest;
}

void StopControl::stop() {
  if (sources_.link == nullptr) return;  // what is played back cannot be stopped
  check_.ask(now_s());
  set_state(State::stopping);
  look_.start(look_interval_ms);
  acted_ = false;
  asked_at_ = newest_tick();
  ask();
}

void StopControl::ask() {
  lost_ = false;
  sources_.link->call("stop", nlohmann::json::object(),
                      [this](const nlohmann::json&, const std::string& trouble) {
                        lost_ = !trouble.empty();
                        if (!lost_ && !acted_) check_.accepted(newest_tick());
                      });
}

/// Rows from the tick on in which a gate obeyed can confirm it. A gate that had been stopped before
/// says nothing: then it is those that come after the answer.
void StopControl::hear_event(const RunEvent& event) {
  if (state_ != State::stopping || acted_ || event.kind != "fault" || event.tick <= asked_at_ ||
      !event.detail.starts_with("operator stop"))
    return;
  acted_ = true;
  check_.accepted(event.tick - 1);
}

void StopControl::forget() {
  if (state_ != State::confirmed) return;
  check_ = {};
  set_state(State::idle);
}

void StopControl::look() {
  if (state_ != State::stopping && state_ != State::not_confirmed) return;
  if (lost_ && sources_.link->offers("stop")) ask();
  check_.saw(now_s(), newest_tick(), renders(sources_.data, signals_));
  if (sources_.live != nullptr && sources_.link->state() == LinkState::open &&
      sources_.live->state().run > 0 && !sources_.live->state().running)
    check_.saw_end(now_s());
  if (check_.confirmed_after()) {
    look_.stop();
    return set_state(State::confirmed);
  }
  if (state_ == State::stopping && check_.overdue(now_s())) {
    set_state(State::not_confirmed);
    Q_EMIT not_confirmed();
  }
}

void StopControl::set_state(State state) {
  if (state == state_ && state != State::stopping) return;
  state_ = state;
  Q_EMIT changed();
}

}  // namespace trocar::gui
