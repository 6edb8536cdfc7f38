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
};

/// Where each value stands in a row: header, the components' times, the ports in the order of the
/// schedule with a group's together, each aligned to its own size, which is how CDR lays out the
/// nested messages of the schema.
class RowLayout {
 public:
  using Selection = std::function<bool(const std::string& port_name)>;

  /// @param wanted which ports to take; a device's are always taken
  explicit RowLayout(const WiredGraph& graph, const Selection& wanted = {});

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
  void add_segment(const RowPort& port);

  std::vector<std::string> components_;  // in the order of the schedule
  std::vector<RowPort> ports_;
  std::vector<Segment> segments_;
  std::size_t size_ = 0;
  bool has_gaps_ = false;  // for alignment
};

}  // namespace trocar
