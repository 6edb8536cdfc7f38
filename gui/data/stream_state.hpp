// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace trocar::gui {

/// What the stream tells of the run and of itself, besides rows: "/trocar/state".
struct StreamState {
  std::int64_t run = 0;  // its number, 0 before the first
  bool running = false;
  bool virtual_time = false;
  double time = 0.0;        // [s]
  std::string script;       // its file's name
  std::string sha256;       // of its text, in hex
  std::string log;          // of the run itself, "" when it records none
  std::string log_trouble;  // why that takes no more rows
  struct Recording {        // that clients asked for
    std::string file;
    std::int64_t rows = 0;
    std::int64_t missed = 0;
  } recording;
  std::string trouble;             // of recording
  std::int64_t stream_missed = 0;  // rows that the stream itself was too slow for
  int clients = 0;
};

/// Nothing when the message is not one of a server of ours.
std::optional<StreamState> read_state(std::span<const std::byte> message);

}  // namespace trocar::gui
