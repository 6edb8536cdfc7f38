// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "gui/operate/named_signals.hpp"
#include "gui/window/page.hpp"

namespace trocar::gui {

enum class Mode { nothing, live, simulated, replay };
const char* to_string(Mode mode);  // "LIVE"

/// In the order of what an operator has to know first.
enum class RunState { unknown, no_run, ended, stopped, cold, holding, engaging, engaged };
const char* to_string(RunState state);  // "ENGAGED"

/// What is going on, as the device and the loop themselves said in their newest rows and events:
/// never what was asked for. Where nothing is heard any more it is unknown, and the device may
/// still be engaged.
struct RunStatus {
  Mode mode = Mode::nothing;
  RunState state = RunState::no_run;
  std::string state_note;    // what more there is to say of it: "homing", "the device may …"
  std::optional<bool> hand;  // on the dead-man; none where there is no such thing
  double time = 0.0;         // [s] since the run's start
  std::int64_t tick = 0;

  double force = 0.0, moment = 0.0;          // [N, N m] at the handle, let through by the gate
  double force_cap = 0.0, moment_cap = 0.0;  // [N, N m]
  double scale = 1.0;                        // share that the gate let through
  bool has_force = false;

  double rate = 0.0;        // [Hz]
  double late_p99 = 0.0;    // [s] over the last second
  double margin = 1.0;      // of the period, that 99 % of ticks leave
  double report_age = 0.0;  // [s]
  bool has_report_age = false;
  std::uint64_t missed = 0;  // slots that the loop skipped, since rows are seen
  bool fault = false;        // is latched

  /// What is shown is what was, not what is.
  bool stale() const { return state == RunState::unknown || state == RunState::ended; }

  /// What rows cannot tell.
  struct Heard {
    double rows_silent_for = 0.0;  // [s] since the newest row came
    bool runtime_ended = false;    // a process of our own, which is gone
  };
  /// @param signals of the graph, as far as it is known
  static RunStatus of(const Sources& sources, const NamedSignals& signals, const Heard& heard);
  static RunStatus of(const Sources& sources, const NamedSignals& signals) {
    return of(sources, signals, Heard());
  }
};

}  // namespace trocar::gui
