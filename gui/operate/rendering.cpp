// SPDX-License-Identifier: Apache-2.0
#include "gui/operate/rendering.hpp"

#include <cmath>
#include <vector>

namespace trocar::gui {
namespace {

constexpr double force_tolerance = 6.0;   // [N]
constexpr double moment_tolerance = 0.4;  // [N m]

/// The newest value of each number of an output, and its unit.
struct Parts {
  std::vector<double> values;
  std::vector<std::string> units;
};

Parts parts_of(const DataStore& data, const std::string& port) {
  Parts parts;
  if (port.empty()) return parts;
  for (const auto& track : data.tracks()) {
    if (track->view_end() == track->first()) continue;
    for (std::size_t i = 0; i < track->signal_list().size(); ++i)
      if (track->signal_list()[i].port == port) {
        parts.values.push_back(track->column(i)[track->view_end() - 1]);
        parts.units.push_back(track->signal_list()[i].unit);
      }
  }
  return parts;
}

bool a_gate_renders(const DataStore& data) {
  for (const auto& track : data.tracks()) {
    const auto flags = track->find("flags");
    if (!flags || track->view_end() == track->first()) continue;
    if ((static_cast<int>(track->column(*flags)[track->view_end() - 1]) & 2) != 0) return true;
  }
  return false;
}

bool device_says_engaged(const DataStore& data, const NamedSignals& signals) {
  const auto state = signals.device_state.empty() ? std::nullopt : data.find(signals.device_state);
  const double number = state ? state->last() : std::nan("");
  const auto label = static_cast<std::size_t>(number >= 0 ? number : 0);
  return number >= 0 && label < signals.device_states.size() &&
         signals.device_states[label] == "engaged";
}

bool amplifiers_do_more(const DataStore& data, const NamedSignals& signals) {
  const Parts applied = parts_of(data, signals.applied);
  const Parts hold = parts_of(data, signals.hold);
  for (std::size_t i = 0; i < applied.values.size(); ++i) {
    const double held = i < hold.values.size() ? hold.values[i] : 0.0;
    const double tolerance = applied.units[i] == "N m" ? moment_tolerance : force_tolerance;
    if (!(std::abs(applied.values[i] - held) <= tolerance) &&
        !(std::abs(applied.values[i]) <= tolerance))
      return true;
  }
  return false;
}

}  // namespace

bool renders(const DataStore& data, const NamedSignals& signals) {
  return a_gate_renders(data) || device_says_engaged(data, signals) ||
         amplifiers_do_more(data, signals);
}

}  // namespace trocar::gui
