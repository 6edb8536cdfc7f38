// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gui/data/data_store.hpp"
#include "gui/data/live_feed.hpp"
#include "gui/watch/watched_run.hpp"

namespace trocar::gui {

/// All that `trocar watch` knows at a moment.
struct WatchView {
  std::string url;
  LinkState link = LinkState::closed;
  std::string why;  // it is not open
  double round_trip_ms = -1.0;
  StreamState state;
  std::vector<const WatchedThread*> threads;
  std::vector<std::string> patterns;  // of the signals to show; all when empty
  std::vector<std::string> remarks;   // the newest last
};

/// "LIVE", "engaged", …: what a person needs to know first, in a line.
std::string headline(const WatchView& view);
/// The signals that `patterns` mean, under each other.
std::vector<std::string> signal_lines(const WatchView& view);
/// What fits a terminal; says how many signals did not.
std::string screen_text(const WatchView& view, std::size_t width, std::size_t height);

std::string event_text(const RunEvent& event);

nlohmann::ordered_json values_json(const WatchedThread& thread,
                                   const std::vector<std::string>& patterns);
nlohmann::ordered_json event_json(const RunEvent& event);

}  // namespace trocar::gui
