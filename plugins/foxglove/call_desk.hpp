// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "framework/realtime/handover.hpp"
#include "framework/realtime/stop_flag.hpp"
#include "framework/run_control.hpp"
#include "framework/stream/server_message.hpp"
#include "plugins/foxglove/recording.hpp"

namespace trocar::foxglove {

/// The services that clients can call, and what each does. Arguments and results are JSON.
class CallDesk {
 public:
  explicit CallDesk(Recording& recording) : recording_(recording) {}

  /// What is offered, numbered from 1.
  static std::vector<stream::ServiceOffer> offers();
  /// Whether anybody may call it, without a token.
  static bool open_to_all(std::string_view service) {
    return service == "stop" || service == "graph" || service == "parameters";
  }
  /// Those that need no run.
  static bool answers_by_itself(std::string_view service) { return service == "start"; }

  /// @param arguments a JSON object, or "" for none
  /// @return a JSON object
  /// @throw std::exception with what is wrong
  std::string call(const std::string& service, const std::string& arguments, RunControl& control);
  /// Lets a run begin that waits for it.
  void start() { started_.raise(); }
  bool started() const { return started_.raised(); }
  void set_graph(std::string json) { graph_.put(std::move(json)); }

 private:
  const std::string& graph();

  Recording& recording_;
  StopFlag started_;
  Handover<std::string> graph_;  // of the run that begins
  std::string graph_now_ = "{}";
};

}  // namespace trocar::foxglove
