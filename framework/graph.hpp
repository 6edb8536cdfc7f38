// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "framework/connection.hpp"
#include "framework/finding.hpp"
#include "framework/registry.hpp"

namespace trocar {

using NodeId = std::size_t;
using ThreadId = std::size_t;

struct OutputRef {
  NodeId node = 0;
  std::string port;
  std::string path{};                         // of a field: "position.z"; "" is the whole value
  std::optional<Connection> connection = {};  // to another thread
};

struct InputRef {
  NodeId node = 0;
  std::string port;
};

struct ParameterRef {
  NodeId node = 0;
  std::string name;
};

/// A named point of a tool: where its motion is read, and where forces on it go.
struct Site {
  OutputRef position;
  OutputRef velocity;
  std::optional<InputRef> force;  // rendered through the motors
  std::optional<InputRef> moment;
  std::optional<InputRef> load;  // acts on the tool from outside
};

/// What a group lets the outside use, by the names that it gives.
struct Exports {
  std::map<std::string, OutputRef, std::less<>> outputs{};
  std::map<std::string, InputRef, std::less<>> inputs{};
  std::map<std::string, Site, std::less<>> sites{};
  std::map<std::string, NodeId, std::less<>> parts{};
};

/// The description of a dataflow graph: what a script builds, what a runtime is made from. It
/// never throws on a mistake of its user but adds a finding and goes on, so that one report can
/// name them all.
class Graph {
 public:
  /// A parameter's value from outside, e.g. `--set wall.stiffness="3 N/mm"`.
  struct Override {
    Literal value;
    Where where;
    bool used = false;
  };
  using Overrides = std::map<std::string, Override, std::less<>>;  // by "wall.stiffness"

  struct Node {
    std::string name;  // full: "laparoscope.device"
    const ComponentType* type = nullptr;
    Where where;
    std::unique_ptr<Component> component{};  // a prototype: holds declarations and settings
    std::unique_ptr<ParameterSet> group{};   // of a group: its parameters
    Exports exports{};                       // of a group
    double rate = 0.0;                       // [Hz]; 0 is the thread's
    std::int64_t phase = 0;                  // [ticks of the thread]
    ThreadId thread = main_thread;
    std::map<std::string, Where, std::less<>> set_at{};  // where each parameter was set

    const ParameterSet& settings() const;
    bool is_group() const { return group != nullptr; }
  };
  /// A thread of the loop: what runs in it runs at its rate, in one order.
  struct Thread {
    std::string name;
    double rate = 0.0;   // [Hz]; 0 is the run's
    double phase = 0.0;  // [s] by which its slots come later
    int priority = 80;   // of SCHED_FIFO; at the same virtual time the higher goes first
    std::optional<int> processor{};  // that it keeps to
    Where where;
  };
  struct Link {  // a parameter that follows another
    ParameterRef from;
    ParameterRef to;
    Where where;
  };
  struct Wire {
    OutputRef from;
    InputRef to;
    Where where;
  };

  static constexpr ThreadId main_thread = 0;  // where nobody says another

  explicit Graph(const Registry& registry) : registry_(registry) {
    threads_.push_back({.name = "main", .where = {}});
  }

  /// Adds a thread; what it must not be is a finding.
  ThreadId add_thread(Thread thread);
  /// Gives a thread another name; what is wrong with it, or "".
  std::string rename_thread(ThreadId thread, std::string_view name);
  const std::vector<Thread>& threads() const { return threads_; }
  /// The thread that added components belong to.
  ThreadId current_thread() const { return current_thread_; }

  /// Adds a component or builds a group; nothing, and a finding, when that cannot be.
  /// @param name "" takes the type's in snake_case
  std::optional<NodeId> add(std::string_view type, std::string_view name, const Where& where,
                            std::string_view scope = "");
  /// Adds a component of a type that no registry has: one that a file defines.
  std::optional<NodeId> add(std::unique_ptr<ComponentType> type, std::string_view name,
                            const Where& where, std::string_view scope);
  /// Adds a group whose parameters somebody else declared.
  std::optional<NodeId> add_group(std::unique_ptr<ParameterSet> parameters, std::string_view type,
                                  std::string_view name, const Where& where,
                                  std::string_view scope);
  /// Builds a registered group's parts, once its parameters are set.
  void build_group(NodeId group);

  void set(const ParameterRef& parameter, const Literal& value, const Where& where);
  void link(const ParameterRef& from, const ParameterRef& to, const Where& where);
  void connect(const OutputRef& from, const InputRef& to, const Where& where);
  /// Wires a fixture or a load to a site.
  void place(NodeId node, const Site& site, const Where& where);
  void set_rate(NodeId node, double rate, std::int64_t phase, const Where& where);
  /// Another name for a node within a scope; what is wrong with it, or "".
  std::string rename(NodeId node, std::string_view name, std::string_view scope);
  /// `stem`, or "stem_2", "stem_3", … where that is taken within the scope.
  std::string unused_name(const std::string& stem, const std::string& scope);
  void finding(const Where& where, std::string message) {
    findings_.add(where, std::move(message));
  }

  const Node& node(NodeId id) const { return nodes_[id]; }
  Node& node(NodeId id) { return nodes_[id]; }
  std::size_t size() const { return nodes_.size(); }
  std::optional<NodeId> find(std::string_view name) const;
  /// The innermost group that a node is a part of.
  std::optional<NodeId> group_of(NodeId node) const;
  /// What a parameter follows, or null.
  const Link* link_to(const ParameterRef& parameter) const;
  const std::vector<Wire>& wires() const { return wires_; }
  const std::vector<Link>& links() const { return links_; }
  const Findings& findings() const { return findings_; }
  const Registry& registry() const { return registry_; }

  /// Parameter values that win over the script's. Set them before anything is added.
  Overrides overrides{};
  /// Every parameter of every node: "wall.stiffness".
  std::vector<std::string> parameter_keys() const;
  /// Adds a finding for each override that names nothing.
  void report_unused_overrides();

 private:
  friend class ThreadScope;
  std::optional<std::string> free_name(std::string_view type, std::string_view name,
                                       const Where& where, std::string_view scope);
  std::optional<NodeId> add_of_type(const ComponentType& type, std::string_view name,
                                    const Where& where, std::string_view scope);
  void apply_overrides(NodeId id);
  void give_back(const std::string& name);

  const Registry& registry_;
  std::vector<std::unique_ptr<ComponentType>> own_types_;
  std::vector<Node> nodes_;
  std::map<std::string, NodeId, std::less<>> by_name_;
  std::vector<Wire> wires_;
  std::vector<Link> links_;
  std::map<std::pair<NodeId, std::string>, std::size_t> link_into_;  // the last, in links_
  std::map<std::string, int> first_unused_;  // by "scope.stem": all numbers below are taken
  std::vector<Thread> threads_;
  ThreadId current_thread_ = main_thread;
  Findings findings_;
};

/// While it lives, what is added belongs to a thread.
class ThreadScope {
 public:
  ThreadScope(Graph& graph, ThreadId thread) : graph_(graph), before_(graph.current_thread_) {
    graph.current_thread_ = thread;
  }
  ~ThreadScope() { graph_.current_thread_ = before_; }
  ThreadScope(const ThreadScope&) = delete;
  ThreadScope& operator=(const ThreadScope&) = delete;

 private:
  Graph& graph_;
  ThreadId before_;
};

/// What Group::build works with: adds parts under the group's name.
class GroupScope {
 public:
  GroupScope(Graph& graph, NodeId group) : graph_(graph), group_(group) {}

  NodeId add(std::string_view type, std::string_view name);
  void connect(const OutputRef& from, const InputRef& to);
  void set(NodeId node, std::string_view parameter, const Literal& value);
  /// Builds a part that is a group itself, once its parameters are set.
  void build(NodeId group) { graph_.build_group(group); }
  /// The part's parameter follows the group's.
  void forward(std::string_view parameter, NodeId node, std::string_view part_parameter);
  Exports& exports() { return graph_.node(group_).exports; }

 private:
  Graph& graph_;
  NodeId group_;
};

}  // namespace trocar
