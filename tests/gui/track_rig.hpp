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

/// A thread's rows made by hand: the head, then numbers in newtons. Names with dots are of nested
/// messages, and those of one stand together.
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
    std::vector<Ros2Message> messages(1);
    for (Ros2Field& field : nest(names_, "trocar/Part", messages)) fields.push_back(field);
    messages.front() = {"trocar/Row", fields, {}};
    schema_ = ros2_schema_text(messages);
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
  static std::vector<Ros2Field> nest(const std::vector<std::string>& names, const std::string& type,
                                     std::vector<Ros2Message>& messages) {
    std::vector<Ros2Field> fields;
    for (std::size_t i = 0; i < names.size();) {
      const std::size_t dot = names[i].find('.');
      if (dot == std::string::npos) {
        fields.push_back({names[i++], "float64", 0, "[N]"});
        continue;
      }
      const std::string head = names[i].substr(0, dot + 1);
      std::vector<std::string> below;
      for (; i < names.size() && names[i].starts_with(head); ++i)
        below.push_back(names[i].substr(head.size()));
      const std::string name = head.substr(0, dot);
      const std::string its_type = type + std::to_string(fields.size());
      const std::vector<Ros2Field> its_fields = nest(below, its_type, messages);
      messages.push_back({its_type, its_fields, {}});
      fields.push_back({name, its_type, 0, {}});
    }
    return fields;
  }

  std::vector<std::string> names_;
  std::string schema_;
};

}  // namespace trocar::test
