// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/parameter.hpp"
#include "framework/realtime/spsc_queue.hpp"

namespace trocar {

class ReloadTicket;

/// What an operator or a script asks of a running graph; taken at the beginning of a tick.
struct Command {
  enum class Kind {
    set_parameter,
    engage,
    acknowledge,
    home,
    stop_rendering,
    end,
    annotate,
    replace,  // what a ticket has made ready; where it has nothing, the refusal is reported
    reload    // in virtual time: the ticket makes it ready first
  };
  Kind kind = Kind::end;
  std::int64_t not_before = 0;  // tick
  // set_parameter: checked against unit and range by whoever sends it.
  ParameterBase* parameter = nullptr;
  const char* owner = "";  // component
  std::array<double, max_axes> target{};
  ReloadTicket* ticket = nullptr;  // of replace and reload
  const char* text = "";           // of annotate; lives as long as the run
};

/// What an operator asks of all threads of a run at once, at a time or now.
struct OperatorRequest {
  double at = 0.0;  // [s]
  Command::Kind kind = Command::Kind::end;
};

/// "stop" (the rendering), "acknowledge", "home", "engage", "end" (the run).
std::optional<Command::Kind> request_named(std::string_view name);
const char* request_name(Command::Kind kind);
std::vector<std::string> request_names();

using CommandQueue = SpscQueue<Command, 256>;

}  // namespace trocar
