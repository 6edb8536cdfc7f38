// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "framework/run.hpp"
#include "tests/support/test_components.hpp"

namespace trocar::test {

/// Outputs of every scalar that follow from the tick and a live gain.
class Meter final : public Component {
 public:
  Parameter<double> gain{this, "gain", {.unit = "N", .initial = "2 N", .max = "9 N", .live = true}};
  Parameter<double> fixed{this, "fixed", {.unit = "N", .initial = "0 N"}};
  Parameter<std::int64_t> broken_from{this, "broken_from", {.initial = "1e15"}};
  Output<bool> odd{this, "odd", {}};
  Output<double> value{this, "value", {.unit = "N"}};
  Output<Vector3> force{this, "force", {.unit = "N", .frame = "device"}};
  Output<std::int64_t> count{this, "count", {}};

  Meter() { place({.force = &force}); }
  void step(const Tick& tick) RT_SAFE override {
    const auto index = static_cast<double>(tick.index);
    *odd = tick.index % 2 == 1;
    *value = *gain + index;
    *force = {index, *gain * index, -index};
    *count = -tick.index;
    if (tick.index >= *broken_from) *value = force->x = std::numeric_limits<double>::quiet_NaN();
  }
};

/// Counts what it is given and throws where the test says.
class TestSink final : public RowSink {
 public:
  enum class Throws { never, in_begin, in_row, in_event, in_end, without_a_word };
  explicit TestSink(Throws when = Throws::never) : when_(when) {}
  void begin(const std::vector<RowLayout>&, const WiredGraph&) override {
    fail_in(Throws::in_begin);
  }
  void row(std::size_t, std::span<const std::byte>) override {
    ++rows;
    fail_in(Throws::in_row);
    if (when_ == Throws::without_a_word) throw 7;
  }
  void event(std::size_t, const Event& event) override {
    kinds.push_back(event.kind);
    fail_in(Throws::in_event);
  }
  void end() override {
    ++ends;
    fail_in(Throws::in_end);
  }
  int rows = 0;
  int ends = 0;
  std::vector<Event::Kind> kinds{};

 private:
  void fail_in(Throws here) const {
    if (when_ == here) throw std::runtime_error("sink is full");
  }
  Throws when_;
};

/// Virtual time, rows kept.
inline RunOptions wanted(std::optional<double> duration = {}) {
  RunOptions options;
  options.clock = ClockKind::simulated;
  options.duration = duration;
  options.keep_rows = true;
  return options;
}

/// A meter and a device in virtual time.
struct RunRig {
  RunRig() {
    types.add<Meter>("Meter", "test", "numbers that follow from the tick");
    meter = graph.add("Meter", "meter", {"test", 1}).value();
    graph.add("TestDevice", "arm", {"test", 2}).value();
  }
  RunRig(const RunRig&) = delete;
  RunRig& operator=(const RunRig&) = delete;

  RunResult run(double duration, const std::vector<RowSink*>& sinks = {},
                const std::vector<Edit>& edits = {}) {
    RunOptions options = wanted(duration);
    options.sinks = sinks;
    options.edits = edits;
    return trocar::run(graph, options);
  }

  Registry types = registry();
  Graph graph{types};
  NodeId meter = 0;
};

inline Edit edit_of(std::string_view key, std::string_view value, double at = 0.0) {
  return {.at = at,
          .key = std::string(key),
          .value = literal_from_text(value),
          .where = {"rig.lua", 7}};
}

}  // namespace trocar::test
