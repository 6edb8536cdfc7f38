// SPDX-License-Identifier: Apache-2.0
#include "gui/data/data_store.hpp"

#include <algorithm>

#include "framework/recording/cdr.hpp"

namespace trocar::gui {

RunEvent read_event(std::span<const std::byte> message) {
  CdrReader cdr(message);
  RunEvent event;
  event.tick = cdr.number<std::int64_t>();
  event.time = static_cast<double>(cdr.number<std::int64_t>()) / 1e9;
  event.thread = cdr.string();
  event.kind = cdr.string();
  event.source = cdr.string();
  event.detail = cdr.string();
  event.value = cdr.number<double>();
  event.limit = cdr.number<double>();
  return event;
}

double SignalRef::last() const {
  return has_value() ? column()[track->end() - 1] : std::numeric_limits<double>::quiet_NaN();
}

void DataStore::begin_run(std::vector<std::unique_ptr<Track>> tracks) {
  // Those who listen to the signal may still hold on to the old ones until they hear it.
  const auto old = std::exchange(tracks_, std::move(tracks));
  events_.clear();
  Q_EMIT run_began();
}

Track* DataStore::track(std::string_view name) const {
  const auto found = std::find_if(tracks_.begin(), tracks_.end(),
                                  [&](const auto& one) { return one->name() == name; });
  return found == tracks_.end() ? nullptr : found->get();
}

std::optional<SignalRef> DataStore::find(std::string_view signal) const {
  for (const std::unique_ptr<Track>& track : tracks_)
    if (const auto index = track->find(signal)) return SignalRef{track.get(), *index};
  return std::nullopt;
}

double DataStore::now() const {
  double now = 0.0;
  for (const std::unique_ptr<Track>& track : tracks_)
    if (!track->empty()) now = std::max(now, track->time(track->end() - 1));
  return now;
}

void DataStore::add_event(RunEvent event) {
  events_.push_back(std::move(event));
  if (events_.size() > most_events) events_.pop_front();
  Q_EMIT event_added(events_.back());
}

}  // namespace trocar::gui
