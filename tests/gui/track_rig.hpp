// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "framework/recording/row_layout.hpp"
#include "gui/data/data_store.hpp"

namespace trocar::test {

/// A thread's rows made by hand: the head, then numbers in newtons.
class TrackRig {
 public:
  explicit TrackRig(std::vector<std::string> names, double seconds = 60.0,
                    std::size_t memory = std::size_t{256} << 20)
      : names_(std::move(names)) {
    std::vector<Ros2Field> fields = {{"tick", "int64", 0, {}},
                                     {"time", "int64", 0, "[ns]"},
                                     {"lateness", "int64", 0, "[ns]"},
                                     {"duration", "int64", 0, "[ns]"},
                                     {"flags", "int64", 0, {}}};
    for (const std::string& name : names_) fields.push_back({name, "float64", 0, "[N]"});
    schema_ = ros2_schema_text({{"trocar/Row", fields, {}}});
    begin(seconds, memory);
  }

  /// Another run, in the store.
  void begin(double seconds = 60.0, std::size_t memory = std::size_t{256} << 20) {
    std::vector<std::unique_ptr<gui::Track>> tracks;
    tracks.push_back(
        std::make_unique<gui::Track>("main", "trocar/Row", schema_, 0.0, seconds, memory));
    track = tracks.front().get();
    store.begin_run(std::move(tracks));
  }

  std::vector<std::byte> row(const RowHeader& header, const std::vector<double>& values) const {
    std::vector<std::byte> bytes(sizeof header + 8 * values.size());
    std::memcpy(bytes.data(), &header, sizeof header);
    std::memcpy(bytes.data() + sizeof header, values.data(), 8 * values.size());
    return bytes;
  }
  /// Ticks at `rate` [Hz] whose numbers are those of `value(name's number, tick)`.
  void feed(std::int64_t from, std::int64_t to, double rate,
            const std::function<double(std::size_t, std::int64_t)>& value) {
    std::vector<double> values(names_.size());
    for (std::int64_t tick = from; tick < to; ++tick) {
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(i, tick);
      track->add(row({.tick = tick, .time = static_cast<std::int64_t>(1e9 / rate) * tick}, values));
    }
  }

  gui::DataStore store;
  gui::Track* track = nullptr;

 private:
  std::vector<std::string> names_;
  std::string schema_;
};

}  // namespace trocar::test
