// SPDX-License-Identifier: Apache-2.0
#include "plugins/foxglove/tap.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>

#include "framework/recording/event_message.hpp"
#include "framework/recording/row_pump.hpp"
#include "framework/wired_graph.hpp"

namespace trocar::foxglove {
namespace {

constexpr std::size_t largest_event = 64u * 1024;  // [B]

/// Each output that somebody reads, or that could be looked at, as a topic.
std::vector<stream::Topic> topics_of(const WiredGraph& graph) {
  std::vector<stream::Topic> topics;
  std::map<const OutputPort*, std::size_t> places;
  const auto each_component = [&](auto&& visit) {
    for (const RateGroup& group : graph.groups())
      for (const ScheduleItem& item : group.schedule()) visit(*item.component);
  };
  each_component([&](const Component& component) {
    for (const OutputPort* output : component.outputs()) {
      places[output] = topics.size();
      topics.push_back({component.name() + "." + output->name(), {component.name()}, {}});
    }
  });
  each_component([&](const Component& component) {
    for (const InputPort* input : component.inputs())
      for (const Source& source : input->sources())
        if (const auto found = places.find(source.output); found != places.end()) {
          std::vector<std::string>& readers = topics[found->second].subscribers;
          if (std::find(readers.begin(), readers.end(), component.name()) == readers.end())
            readers.push_back(component.name());
        }
  });
  return topics;
}

}  // namespace

std::uint64_t date_now() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
}

void Tap::begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) {
  std::size_t largest = largest_event;
  std::size_t capacity = 0;
  for (const RowLayout& layout : layouts) {
    largest = std::max(largest, layout.size());
    capacity +=
        ring_capacity(layout, static_cast<double>(layout.period_ns()) * 1e-9, next_.virtual_time);
  }
  const std::uint64_t epoch_ns = next_.virtual_time ? 0 : date_now();
  run_ = std::make_shared<StreamRun>(
      RunDescription{++number_, layouts, topics_of(graph), epoch_ns, next_.recording}, capacity,
      largest);
  while (!runs_.put(run_)) runs_.take_all();  // nobody looks at runs as short as those
  recording_.begin_run(layouts, graph, epoch_ns, next_.graph);
}

void Tap::write(TapRecord kind, std::size_t group, std::span<const std::byte> bytes) {
  const std::span<std::byte> room = run_->ring.begin(bytes.size());
  if (room.empty()) return;
  std::memcpy(room.data(), bytes.data(), bytes.size());
  run_->ring.commit(static_cast<std::uint32_t>(group << 2) | static_cast<std::uint32_t>(kind));
}

void Tap::row(std::size_t group, std::span<const std::byte> row) {
  write(TapRecord::row, group, row);
  recording_.row(group, row);
}

void Tap::event(std::size_t group, const Event& event) {
  const std::string& thread = run_->layouts[group].name();
  write_event(event, thread, message_);
  if (message_.size() > largest_event - sizeof event.time_ns) {
    Event shorter = event;
    shorter.detail = "too long for the stream: the log has it";
    write_event(shorter, thread, message_);
  }
  record_.resize(sizeof event.time_ns + message_.size());
  std::memcpy(record_.data(), &event.time_ns, sizeof event.time_ns);
  std::memcpy(record_.data() + sizeof event.time_ns, message_.data(), message_.size());
  write(TapRecord::event, group, record_);
  recording_.event(group, event);
}

void Tap::end() {
  const std::byte nothing[8] = {};
  write(TapRecord::end, 0, nothing);
  recording_.end_run();
}

}  // namespace trocar::foxglove
