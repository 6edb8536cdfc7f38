// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/data/track.hpp"

namespace trocar::gui {

/// An event of a run, as logs and streams tell it.
struct RunEvent {
  std::int64_t tick = 0;
  double time = 0.0;  // [s]
  std::string thread;
  std::string kind;    // "fault", "gate", "edit", …: docs/log-format.md
  std::string source;  // component
  std::string detail;
  double value = 0.0;
  double limit = 0.0;

  bool operator==(const RunEvent&) const = default;
};

/// @throw std::runtime_error when the bytes are not a "trocar/Event" as CDR
RunEvent read_event(std::span<const std::byte> message);

/// One that people look for: a fault, a remark, what was refused, rows missed.
bool is_marked(const RunEvent& event);

/// A column of a track.
struct SignalRef {
  const Track* track = nullptr;
  std::size_t index = 0;

  const SchemaSignal& info() const { return track->signal_list()[index]; }
  const Column& column() const { return track->column(index); }
  bool has_value() const { return track != nullptr && !track->empty(); }
  double last() const;  // of what is shown; NaN when there is none yet
};

/// What is known of one run: rows and events, wherever they come from. Everybody who looks at
/// data looks here, so that a live run and a log are looked at with the same eyes.
class DataStore : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t most_events = 10'000;

  explicit DataStore(QObject* parent = nullptr) : QObject(parent) {}

  /// Forgets what there is; references to tracks end.
  void begin_run(std::vector<std::unique_ptr<Track>> tracks);
  const std::vector<std::unique_ptr<Track>>& tracks() const { return tracks_; }
  Track* track(std::string_view name) const;  // null when there is none
  /// "wall.force.z"; where several threads have it, the first.
  std::optional<SignalRef> find(std::string_view signal) const;
  double newest() const;  // [s] of the newest row of all

  /// Where what is shown ends [s]: at the newest row, or where playback stands.
  double now() const { return view_end_.value_or(newest()); }
  /// Playback: rows and events behind `time` [s] are there, but not shown yet. None: all are.
  void set_view_end(std::optional<double> time);

  const std::deque<RunEvent>& events() const { return events_; }
  /// How many of events() are shown: those up to now().
  std::size_t events_shown() const;
  void add_event(RunEvent event);

 Q_SIGNALS:
  void run_began();                                // tracks are new
  void event_added(const trocar::gui::RunEvent&);  // the oldest may have gone

 private:
  std::vector<std::unique_ptr<Track>> tracks_;
  std::deque<RunEvent> events_;
  std::optional<double> view_end_;
};

}  // namespace trocar::gui
