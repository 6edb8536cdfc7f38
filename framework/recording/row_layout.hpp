// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "framework/recording/ros2_schema.hpp"
#include "framework/wired_graph.hpp"

namespace trocar {

/// What every row begins with.
struct RowHeader {
  enum Flag : std::int64_t { fault_latched = 1, rendering = 2, slots_skipped = 4 };
  std::int64_t tick = 0;
  std::int64_t time = 0;      // [ns] of the slot since the run's start
  std::int64_t lateness = 0;  // [ns] of the tick's beginning; 0 in virtual time
  std::int64_t duration = 0;  // [ns] of the tick before this one; 0 in virtual time
  std::int64_t flags = 0;
};

/// A port's value in the row.
struct RowPort {
  std::string name;  // "laparoscope.device.position"
  Signature signature;
  std::string doc;
  std::vector<std::string> labels;
  std::size_t memory_offset = 0;  // [bytes] in the graph's memory
  std::size_t row_offset = 0;     // [bytes] in the row
  std::size_t size = 0;           // [bytes] that count
};

/// A leaf of a row: a number that can be plotted.
struct RowSignal {
  std::string name;  // "wall.force.z"
  Scalar scalar = Scalar::real;
  Unit unit;
  std::size_t row_offset = 0;
  std::size_t group = 0;  // of which thread's rows
};

/// Where each value stands in a row of one thread: header, the components' times, the ports in the
/// order of the schedule with a group's together and what is read from other threads with the
/// component that reads it, each aligned to its own size, which is how CDR lays out the nested
/// messages of the schema.
class RowLayout {
 public:
  using Selection = std::function<bool(const std::string& port_name)>;

  /// @param wanted which ports to take; a device's are always taken
  explicit RowLayout(const RateGroup& group, const Selection& wanted = {});

  const std::string& name() const { return name_; }  // of the thread
  std::int64_t period_ns() const { return period_ns_; }

  std::size_t size() const { return size_; }
  const std::vector<RowPort>& ports() const { return ports_; }
  std::vector<RowSignal> signals() const;
  /// The row as messages of a `ros2msg` schema, the row itself first. Names that ROS 2 does not
  /// take, or that stand twice, are brought to the nearest that does.
  std::vector<Ros2Message> messages() const;

  /// @param times [ns] of each component in the order of the schedule
  /// @param row of size() bytes
  void capture(const RowHeader& header, std::span<const std::int64_t> times,
               const std::byte* memory, std::span<std::byte> row) const RT_SAFE;

 private:
  struct Segment {  // ports that lie together in both are copied at once
    std::size_t memory_offset, row_offset, size;
  };
  void add_ports(const RateGroup& group, const Selection& wanted);
  void add_segment(const RowPort& port);

  std::string name_;
  std::int64_t period_ns_;
  std::vector<std::string> components_;  // in the order of the schedule
  std::vector<RowPort> ports_;
  std::vector<Segment> segments_;
  std::size_t size_ = 0;
  bool has_gaps_ = false;  // for alignment
};

/// One for each thread.
std::vector<RowLayout> layouts_of(const WiredGraph& graph, const RowLayout::Selection& wanted = {});

}  // namespace trocar
