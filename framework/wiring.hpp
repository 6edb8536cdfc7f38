// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <any>
#include <unordered_map>

#include "framework/wired_graph.hpp"

namespace trocar {

/// A wire between ports that exist.
struct ResolvedWire {
  NodeId from_node = 0;
  NodeId to_node = 0;
  OutputPort* from = nullptr;
  InputPort* to = nullptr;
  std::string path;                      // of the field that is read
  std::optional<Connection> connection;  // to another thread
  Where where;
  std::size_t arrival = 0;  // of one to another thread, in the reader's group

  std::string text() const;  // "sine.value → wall.offset"
};

/// The steps of wire(), each adding what it finds. A step runs only on what earlier ones left
/// sound, so that one mistake is not reported three times.
class Wiring {
 public:
  Wiring(const Graph& graph, const WiringOptions& options);
  ~Wiring();
  Wiring(const Wiring&) = delete;
  Wiring& operator=(const Wiring&) = delete;
  std::unique_ptr<WiredGraph> build();

 private:
  void instantiate();
  void apply_settings();
  ParameterBase* find_parameter(NodeId node, std::string_view name) const;
  std::vector<const Graph::Link*> ordered_links() const;
  void follow_links();
  void require_parameters();
  void resolve_wires();       // names → ports
  void resolve_signatures();  // wiring_signatures.cpp
  void spread_signatures(const std::vector<std::size_t>& open);
  void settle_natural();
  void check_wires();
  void check_inputs();
  void check_truth();  // wiring_dependencies.cpp
  void mark_dependencies();
  std::vector<bool> upstream(const std::vector<const InputPort*>& inputs) const;
  std::vector<bool> upstream(const InputPort& input) const;
  const std::vector<std::size_t>& wires_into(const InputPort& input) const;
  void check_rates();
  void check_connections();  // wiring_threads.cpp
  void make_groups();
  void begin_group(ThreadId thread);
  void add_to_group(NodeId node, std::size_t group);
  void connect_across(const ResolvedWire& wire);
  void order();  // wiring_order.cpp
  void report_loop(const std::vector<NodeId>& waiting);
  void lay_out_memory(RateGroup& group);
  void connect();
  void configure();
  void check_limits();
  void settle_threads();
  /// [Hz] of the thread that a node belongs to.
  double thread_rate(NodeId node) const;
  RateGroup& group_of(NodeId node) { return result_->groups_[group_index_[node]]; }
  const Where& where_of(NodeId node) const { return graph_.node(node).where; }
  Where where_set(NodeId node, const std::string& parameter) const;

  const Graph& graph_;
  WiringOptions options_;
  Findings findings_;
  std::unique_ptr<WiredGraph> result_;
  std::vector<ResolvedWire> wires_;
  std::vector<std::vector<std::size_t>> wires_of_;  // by node, either end: index of wires_
  std::unordered_map<const InputPort*, std::vector<std::size_t>> wires_into_;  // index of wires_
  std::vector<ThreadId> thread_of_;                                            // by node
  std::vector<NodeId> order_;                                                  // of all threads
  std::vector<std::size_t> position_;                                          // by node, in order_
  std::vector<std::size_t> group_index_;                                       // by node
  std::vector<std::size_t> item_index_;  // by node, in its group's schedule
  /// A group's parameters belong to the description: what a run sets there is put back.
  std::vector<std::pair<ParameterBase*, std::any>> borrowed_;
};

}  // namespace trocar
