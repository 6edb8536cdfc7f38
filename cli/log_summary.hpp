// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/log_signals.hpp"
#include "cli/tick_gaps.hpp"

namespace trocar::cli {

/// What a log holds.
struct LogSummary {
  struct Channel {
    std::string topic{};
    std::string schema{};    // name
    std::string encoding{};  // of the messages
    std::uint64_t messages = 0;
    std::uint64_t first_ns = 0, last_ns = 0;  // log time
    bool decoded = false;
    bool rows = false;      // one for each tick, written by Trocar
    TickGaps ticks{};       // of rows
    std::string problem{};  // why it was not decoded, or not to its end
    bool damaged = false;   // its messages do not fit its schema
    std::vector<LogSignal> signal_list{};

    double rate() const;  // [Hz], 0 where unknown
  };
  struct Event {
    std::int64_t tick = 0;
    std::int64_t time_ns = 0;
    std::string thread, kind, source, detail;
    double value = 0.0, limit = 0.0;
  };
  struct Attachment {
    std::string name, media_type;
    std::uint64_t size = 0;  // [B]
  };

  std::string file{};
  std::uint64_t file_size = 0;  // [B]
  std::uint64_t payload = 0;    // of all messages [B]
  std::string library{};        // that wrote it
  std::string problem{};        // why it is not complete, or ""
  std::vector<Channel> channels;
  std::vector<Event> events;
  /// By name, in the order in which the names came; each with its rows.
  std::vector<std::pair<std::string, nlohmann::ordered_json>> published;
  std::vector<Attachment> attachments;

  bool complete() const { return problem.empty(); }
  bool damaged() const;
  double duration() const;  // [s]
};

/// Reads the log at `path`. @param values whether to go through all values of all signals, too
/// @throw std::runtime_error when the file cannot be read, is no MCAP file, or is damaged.
LogSummary summarize_log(const std::string& path, bool values);

}  // namespace trocar::cli
