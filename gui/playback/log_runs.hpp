// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "framework/recording/mcap_reader.hpp"

namespace trocar::gui {

/// A run in a log: "/main" and "/events" are of the first, "/run2/main" and so on of later ones.
struct LogRun {
  struct Thread {
    std::string name;
    std::uint16_t channel = 0;
    double period = 0.0;  // [s], 0: not known
    std::uint64_t rows = 0;
    std::size_t columns = 0;
    std::uint64_t memory() const;  // [B] that all rows take as a track
  };

  int number = 1;
  std::vector<Thread> threads;
  std::optional<std::uint16_t> events;  // channel

  std::uint64_t memory() const;  // [B]
  double duration() const;       // [s] by the rows that there are, and their period
};

/// The runs whose rows a log has, in order.
std::vector<LogRun> runs_of(const McapReader& log);

}  // namespace trocar::gui
