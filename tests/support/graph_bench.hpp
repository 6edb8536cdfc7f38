// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "components/register.hpp"
#include "framework/wired_graph.hpp"

namespace trocar::test {

/// A source whose signal a test makes up.
struct FeedSettings {
  Signature signature;
  std::function<void(double t, std::span<double> values)> law;
  SignalQuality quality{};
};

class Feed final : public Component {
 public:
  explicit Feed(FeedSettings settings) : settings_(std::move(settings)) {
    value.set_signature(settings_.signature);
  }
  void configure(const Setup&) override { value.quality = settings_.quality; }
  void start() override { settings_.law(0.0, value.values()); }
  void step(const Tick& tick) RT_SAFE override { settings_.law(tick.time, value.values()); }

  GenericOutput value{this, "value", {.doc = "what the test says"}};

 private:
  FeedSettings settings_;
};

inline Signature real_in(std::string_view unit) {
  return {&type_info<double>(), 0, {parse_unit(unit)}, ""};
}
inline Signature vector_in(std::string_view unit, std::string_view frame = "device") {
  return {&type_info<Vector3>(), 0, {parse_unit(unit)}, std::string(frame)};
}
inline Signature joints_in(const std::vector<std::string>& units) {
  Signature signature{&type_info<Joints>(), static_cast<int>(units.size()), {}, ""};
  for (const std::string& unit : units) signature.units.push_back(parse_unit(unit));
  return signature;
}

/// A graph of the built-in components and feeds, ticked by hand at 1 kHz.
class GraphBench {
 public:
  GraphBench() : graph(registry) { register_components(registry); }

  using Settings = std::vector<std::pair<std::string, Literal>>;
  NodeId add(std::string_view type, const Settings& settings = {}, std::string_view name = "") {
    const NodeId node = *graph.add(type, name, {"test", 1});
    for (const auto& [parameter, value] : settings)
      graph.set({node, parameter}, value, {"test", 1});
    return node;
  }
  NodeId feed(const FeedSettings& settings) {
    const std::string type = "Feed" + std::to_string(++feeds_);
    registry.add(
        {type, "test", "a test's signal", [=] { return std::make_unique<Feed>(settings); }, {}});
    return add(type);
  }
  void connect(NodeId from, std::string_view output, NodeId to, std::string_view input) {
    graph.connect({from, std::string(output)}, {to, std::string(input)}, {"test", 1});
  }
  /// The findings of wire(), or "" when it stands and is started.
  std::string wire() {
    try {
      wired = trocar::wire(graph, {});
    } catch (const BrokenGraph& broken) {
      return broken.what();
    }
    for (const ScheduleItem& item : wired->main().schedule()) item.component->start();
    return "";
  }
  void tick(std::int64_t ticks = 1) {
    for (std::int64_t i = 0; i < ticks; ++i, ++now_) {
      const Tick tick{now_, now_ * 1'000'000, static_cast<double>(now_) * 1e-3, 1e-3};
      for (const ScheduleItem& item : wired->main().schedule()) item.component->step(tick);
    }
  }
  OutputPort& output(NodeId node, std::string_view name) {
    return *wired->component(node)->find_output(name);
  }
  double number(NodeId node, std::string_view name, std::size_t i = 0) {
    return reinterpret_cast<const double*>(output(node, name).data())[i];
  }

  Registry registry;
  Graph graph;
  std::unique_ptr<WiredGraph> wired;

 private:
  int feeds_ = 0;
  std::int64_t now_ = 0;
};

}  // namespace trocar::test
