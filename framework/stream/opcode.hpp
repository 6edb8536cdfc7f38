// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace trocar::stream {

/// The first byte of a binary message, by who sends it.
enum class ServerOpcode : std::uint8_t { data = 1, time = 2, call_response = 3, asset = 4 };
enum class ClientOpcode : std::uint8_t { data = 1, call = 2 };

}  // namespace trocar::stream
