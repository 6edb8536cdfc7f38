// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "framework/event.hpp"

namespace trocar {

/// How events stand in logs and streams: the `ros2msg` schema of "trocar/Event".
std::string event_schema();

/// The event as a CDR message of that schema, in place of what `into` held.
/// @param thread whose tick it is
void write_event(const Event& event, std::string_view thread, std::vector<std::byte>& into);

}  // namespace trocar
