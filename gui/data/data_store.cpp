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

bool is_marked(const RunEvent& event) {
  return event.kind == "fault" || event.kind == "annotated" || event.kind == "rows missed" ||
         event.kind.ends_with("refused");
}

double SignalRef::last() const {
  const std::uint64_t end = track == nullptr ? 0 : track->view_end();
  return end > 0 && end > track->first() ? column()[end - 1]
                                         : std::numeric_limits<double>::quiet_NaN();
}

void DataStore::begin_run(std::vector<std::unique_ptr<Track>> tracks) {
  // Those who listen to the signal may still hold on to the old ones until they hear it.
  const auto old = std::exchange(tracks_, std::move(tracks));
  events_.clear();
  for (const auto& track : tracks_) track->set_view_end(view_end_);
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

double DataStore::newest() const {
  double newest = 0.0;
  for (const std::unique_ptr<Track>& track : tracks_)
    if (!track->empty()) newest = std::max(newest, track->time(track->end() - 1));
  return newest;
}

void DataStore::set_view_end(std::optional<double> time) {
  view_end_ = time;
  for (const auto& track : tracks_) track->set_view_end(time);
}

std::size_t DataStore::events_shown() const {
  if (!view_end_) return events_.size();
  return static_cast<std::size_t>(
      std::count_if(events_.begin(), events_.end(),
                    [&](const RunEvent& event) { return event.time <= *view_end_; }));
}

void DataStore::add_event(RunEvent event) {
  events_.push_back(std::move(event));
  if (events_.size() > most_events) events_.pop_front();
  Q_EMIT event_added(events_.back());
}

}  // namespace trocar::gui
