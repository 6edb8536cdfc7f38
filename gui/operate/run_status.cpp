// SPDX-License-Identifier: Apache-2.0
#include "gui/operate/run_status.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace trocar::gui {
namespace {

constexpr double window_s = 1.0;   // that the loop's health is judged by
constexpr double silence_s = 0.5;  // after which nobody knows

double value(const DataStore& data, const std::string& name, double otherwise) {
  if (name.empty()) return otherwise;
  const auto found = data.find(name);
  const double last = found ? found->last() : std::nan("");
  return std::isfinite(last) ? last : otherwise;
}

Eigen::Vector3d vector(const DataStore& data, const std::string& name) {
  return {value(data, name + ".x", 0.0), value(data, name + ".y", 0.0),
          value(data, name + ".z", 0.0)};
}

/// At the handle X of a wrench (f; m) about E, as the gate judges it:  m_X = m - (X - E) x f
void judge_force(const DataStore& data, const NamedSignals& signals, RunStatus& status) {
  status.scale = value(data, signals.scale, 1.0);
  status.has_force = !signals.wrench.empty() && data.find(signals.wrench + ".force.x");
  if (!status.has_force) return;
  const Eigen::Vector3d force = vector(data, signals.wrench + ".force");
  Eigen::Vector3d moment = vector(data, signals.wrench + ".moment");
  if (!signals.origin.empty() && !signals.handle.empty())
    moment -= (vector(data, signals.handle) - vector(data, signals.origin)).cross(force);
  status.force = status.scale * force.norm();
  status.moment = status.scale * moment.norm();
}

double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// The device's own thread, or the first.
const Track* track_of(const DataStore& data, const NamedSignals& signals) {
  if (const auto found = signals.scale.empty() ? std::nullopt : data.find(signals.scale))
    return found->track;
  return data.tracks().empty() ? nullptr : data.tracks().front().get();
}

void judge_loop(const Track& track, RunStatus& status) {
  const std::uint64_t end = track.view_end();
  if (end == track.first()) return;
  status.tick = track.tick(end - 1);
  status.time = track.time(end - 1);
  const std::uint64_t begin = track.at(status.time - window_s);
  const double span = status.time - track.time(begin);
  const auto ticks = static_cast<double>(status.tick - track.tick(begin));
  if (span > 0) status.rate = ticks / span;
  const auto lateness = track.find("lateness"), duration = track.find("duration");
  if (!lateness || !duration || status.rate <= 0) return;
  std::vector<double> late, used;
  for (std::uint64_t row = begin; row < end; ++row) {
    late.push_back(1e-9 * track.column(*lateness)[row]);
    used.push_back(late.back() + 1e-9 * track.column(*duration)[row]);
  }
  status.late_p99 = percentile(late, 0.99);
  status.margin = 1.0 - percentile(used, 0.99) * status.rate;
  status.missed = track.missing();
}

struct Flags {
  bool fault = false, rendering = false;
};

Flags flags_of(const Track& track) {
  const std::uint64_t end = track.view_end();
  const auto column = track.find("flags");
  if (!column || end == track.first()) return {};
  const auto flags = static_cast<int>(track.column(*column)[end - 1]);
  return {.fault = (flags & 1) != 0, .rendering = (flags & 2) != 0};
}

/// What the gate said last.
std::string gate_word(const DataStore& data, const std::string& device) {
  const auto shown = static_cast<std::ptrdiff_t>(data.events_shown());
  for (auto event = data.events().begin() + shown; event != data.events().begin();) {
    --event;
    if (event->kind == "gate" && (device.empty() || event->source == device)) return event->detail;
  }
  return "";
}

RunState state_of(bool rendering, bool fault, const std::string& word) {
  if (!rendering && (word == "tripped" || (word.empty() && fault))) return RunState::stopped;
  if (word == "cold") return RunState::cold;
  if (word == "holding" && !rendering) return RunState::holding;
  if (word == "engaging") return RunState::engaging;
  return rendering ? RunState::engaged : RunState::holding;
}

/// A device with states of its own has the last word: what it says of itself is the echo.
void ask_device(const DataStore& data, const NamedSignals& signals, RunStatus& status) {
  if (!signals.dead_man.empty()) status.hand = value(data, signals.dead_man, 0.0) > 0.5;
  const double own = value(data, signals.device_state, -1.0);
  const auto at = static_cast<std::size_t>(own < 0 ? 0 : own);
  if (own < 0 || at >= signals.device_states.size()) return;
  const std::string& word = signals.device_states[at];
  status.state_note = "device: " + word;
  if (word == "engaged") {
    if (status.state != RunState::engaging) status.state = RunState::engaged;
  } else if (status.state == RunState::engaged) {
    status.state = RunState::engaging;
  }
  if (word == "unhomed" || word == "homing") status.state = RunState::cold;
}

/// Whether what the rows say still holds.
void judge_link(const Sources& sources, const RunStatus::Heard& heard, RunStatus& status) {
  const bool link_lost = sources.link != nullptr && sources.link->state() != LinkState::open;
  const bool goes_on = sources.live != nullptr && sources.live->state().running;
  if (heard.runtime_ended || (sources.live != nullptr && !link_lost && !goes_on)) {
    status.state = RunState::ended;
    status.state_note.clear();
  } else if (link_lost) {
    status.state = RunState::unknown;
    status.state_note = "the device may still be engaged";
  } else if (goes_on && heard.rows_silent_for > silence_s) {
    status.state = RunState::unknown;
    status.state_note = "no rows: the device may still be engaged";
  }
}

}  // namespace

const char* to_string(Mode mode) {
  switch (mode) {
    case Mode::nothing:
      return "NO DATA";
    case Mode::live:
      return "LIVE";
    case Mode::simulated:
      return "SIMULATED";
    case Mode::replay:
      return "REPLAY";
  }
  return "?";
}

const char* to_string(RunState state) {
  switch (state) {
    case RunState::unknown:
      return "UNKNOWN";
    case RunState::no_run:
      return "NO RUN";
    case RunState::ended:
      return "RUN ENDED";
    case RunState::stopped:
      return "STOPPED";
    case RunState::cold:
      return "NOT READY";
    case RunState::holding:
      return "HOLDING";
    case RunState::engaging:
      return "ENGAGING";
    case RunState::engaged:
      return "ENGAGED";
  }
  return "?";
}

RunStatus RunStatus::of(const Sources& sources, const NamedSignals& signals, const Heard& heard) {
  RunStatus status;
  const Track* track = track_of(sources.data, signals);
  status.mode = sources.link == nullptr ? Mode::replay
                : track == nullptr      ? Mode::nothing
                : signals.simulated     ? Mode::simulated
                                        : Mode::live;
  status.force_cap = signals.force_cap;
  status.moment_cap = signals.moment_cap;
  if (track != nullptr && !track->empty()) {
    judge_loop(*track, status);
    const Flags flags = flags_of(*track);
    status.fault = flags.fault;
    status.state = state_of(flags.rendering, flags.fault, gate_word(sources.data, signals.device));
    ask_device(sources.data, signals, status);
    judge_force(sources.data, signals, status);
    status.has_report_age = !signals.report_age.empty();
    status.report_age = value(sources.data, signals.report_age, 0.0);
  }
  if (track != nullptr && !track->empty()) judge_link(sources, heard, status);
  return status;
}

}  // namespace trocar::gui
