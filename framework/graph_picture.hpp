// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "framework/wired_graph.hpp"

namespace trocar {

/// What is drawn of a graph, whatever the notation: boxes for components, clusters for threads
/// where there are several and for groups, arrows for wires. Between a device and what feeds its
/// hold and effort stands its gate.
///
/// Left out: inputs that nothing feeds, groups without parts, sites (the names of the ports at
/// either end tell), and parameters that a group forwards to its own parts.
struct GraphPicture {
  enum class Shape { component, device, gate };
  /// When a value is read: in the tick that wrote it, or, where the input has no feedthrough, in
  /// one after it. Or it goes to another thread.
  enum class Line { same_tick, later_tick, other_thread };

  struct Cluster {
    std::string name;                   // full: "laparoscope", "thread servo"
    std::string title;                  // within its own cluster
    std::string type;                   // "" for a group of a script
    std::optional<std::size_t> inside;  // of clusters, before this one
  };
  struct Box {
    std::string name;  // full: "laparoscope.device"; a gate has its device's
    std::string title;
    std::string type;                  // "" where the title says all
    std::vector<std::string> notes{};  // "100 Hz, phase 3", "mount = device.mount"
    Shape shape = Shape::component;
    std::optional<std::size_t> inside{};  // of clusters
  };
  struct Label {
    std::string ports;  // "tip.position → position"; the name alone where both are called alike
    std::string type;   // "Vector3 [m]"
  };
  /// All wires of one kind from one box to another.
  struct Arrow {
    std::size_t from = 0;  // of boxes
    std::size_t to = 0;
    Line line = Line::same_tick;
    std::vector<Label> labels{};
    bool back = false;  // closes a loop: without those that do, all arrows lead one way
  };

  std::vector<Cluster> clusters{};
  std::vector<Box> boxes{};  // in the order of the schedule, gates last
  std::vector<Arrow> arrows{};

  /// A box or a cluster.
  struct Part {
    bool is_cluster = false;
    std::size_t index = 0;
  };
  /// What lies immediately in a cluster, or at the top, in the order of the boxes.
  std::vector<Part> parts_of(std::optional<std::size_t> cluster) const;
};

/// @param wired of the same graph: knows the types of generic ports and the values of parameters
GraphPicture picture_of(const Graph& graph, const WiredGraph& wired);

}  // namespace trocar
