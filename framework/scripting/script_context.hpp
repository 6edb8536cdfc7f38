// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "framework/scripting/lua_value.hpp"
#include "framework/session.hpp"

namespace trocar::lua {

// What scripts hold in their hands: references into the graph's description.
struct NodeRef {
  NodeId node = 0;
};
struct SiteRef {
  Site site;
  std::string name;
};
/// A component's ports of a common first name: `device.truth`.
struct PortGroupRef {
  NodeId node = 0;
  std::string prefix;  // "truth."
};
/// What trocar.thread returned.
struct ThreadRef {
  ThreadId thread = 0;
};
/// Stands for something that does not exist, so that the script goes on and every mistake is
/// found; the finding was made where it arose.
struct Placeholder {
  std::string what;
};
struct RunRef {
  const SessionRun* run = nullptr;
};
/// `run["wall.force"]`, or its length: `run["wall.force"]:norm()`.
struct SignalRef {
  const SessionRun* run = nullptr;
  std::string name;
  bool norm = false;
};
/// What trocar.load returned: a script's graph, to be run.
struct RigRef {
  Session* session = nullptr;
};

template <>
struct Meta<NodeRef> {
  static constexpr const char* name = "trocar.component";
};
template <>
struct Meta<OutputRef> {
  static constexpr const char* name = "trocar.output";
};
template <>
struct Meta<InputRef> {
  static constexpr const char* name = "trocar.input";
};
template <>
struct Meta<ParameterRef> {
  static constexpr const char* name = "trocar.parameter";
};
template <>
struct Meta<SiteRef> {
  static constexpr const char* name = "trocar.site";
};
template <>
struct Meta<PortGroupRef> {
  static constexpr const char* name = "trocar.ports";
};
template <>
struct Meta<ThreadRef> {
  static constexpr const char* name = "trocar.thread";
};
template <>
struct Meta<Placeholder> {
  static constexpr const char* name = "trocar.placeholder";
};
template <>
struct Meta<RunRef> {
  static constexpr const char* name = "trocar.result";
};
template <>
struct Meta<SignalRef> {
  static constexpr const char* name = "trocar.signal";
};
template <>
struct Meta<RigRef> {
  static constexpr const char* name = "trocar.rig";
};

struct SpecContext;

/// What the functions of the binding share; one for each script that runs.
struct ScriptContext {
  Session& session;
  Graph::Overrides arguments;
  std::filesystem::path folder;                  // of the script
  std::vector<std::string> scopes{};             // names of the groups that are being built
  bool ran = false;                              // the script called trocar.run
  bool stopped = false;                          // the operator ended a run, and the script with it
  std::optional<Findings> broken{};              // why a run did not begin
  std::set<NodeId> nameless{};                   // what operators made, until :as names it
  std::set<ThreadId> nameless_threads{};         // until a variable names them
  std::vector<std::string> asked{};              // entries of trocar.args that the script wanted
  std::vector<std::unique_ptr<Session>> rigs{};  // of trocar.load and trocar.experiment
  std::set<const RunResult*> faults_looked_at{};  // the script asked for their faults
  SpecContext* spec = nullptr;                    // of a spec that is being tested

  Graph& graph() { return session.graph(); }
  std::string scope() const { return scopes.empty() ? std::string() : scopes.back(); }
  /// `stem`, or "stem_2", "stem_3", … where that is taken.
  std::string unused_name(const std::string& stem);
  std::string unused_name(const std::string& stem, const std::string& inside);
};

ScriptContext& context(lua_State* state);

/// Runs a session's graph as a script asks, and pushes the result. In a check the script ends here.
int run_session(lua_State* state, Session& session, RunOptions options);
/// The table at `index`, as trocar.run takes it.
/// @param base what holds where the table says nothing
RunOptions run_options_at(lua_State* state, int index, RunOptions base);

/// Adds a finding at the line that is running and pushes a placeholder.
int push_placeholder(lua_State* state, const std::string& what, const std::string& finding);

/// "laparoscope.tool.tip.position"
std::string signal_name(const Graph& graph, const OutputRef& output);

// Each opens its part of the library; the `trocar` table is on top of the stack.
void open_graph(lua_State* state);       // components
void open_signals(lua_State* state);     // outputs, inputs, sites, parameters: of open_graph
void open_arithmetic(lua_State* state);  // + - * on outputs: after open_graph
void open_threads(lua_State* state);     // threads, latest, queue: after open_graph
void open_groups(lua_State* state);
void open_laws(lua_State* state);  // what files in Lua define
void open_runs(lua_State* state);
void open_results(lua_State* state);  // of runs: of open_runs
void open_least_squares(lua_State* state);
void open_rigs(lua_State* state);           // scripts in the hands of scripts
void open_specs(lua_State* state);          // describe, it, expect, as globals
void open_ordered_pairs(lua_State* state);  // as globals
/// require() takes what is preloaded, and files beside the script; no C modules.
void open_require(lua_State* state);

/// "file:3: message" as a finding at that line.
Finding finding_of(const std::string& script, const std::string& message);

/// @throw BrokenGraph when it cannot be read
std::string script_text(const std::string& path);

/// Its content, or nothing when it cannot be read.
std::optional<std::string> read_file(const std::filesystem::path& path);

/// Calls constructor `type` with the table at the top of the stack; pushes the component.
/// @param spare_name where the table gives none; "" is the type's
int construct(lua_State* state, const std::string& type, const std::string& spare_name = "");
/// Adds a component of a type with a definition, which the table at index `table` has; nothing, and
/// findings, where it is wrong.
std::optional<NodeId> add_defined(lua_State* state, int table, const ComponentType& type,
                                  const std::string& name);
/// Gives a new component or group what the table at the top says; pushes the component.
int apply_entries(lua_State* state, NodeId node);
/// Whether components of this type are made by a file in Lua.
bool is_law(const std::string& type);
/// Calls the constructor of such a type with the table at 1; pushes the component.
int construct_law(lua_State* state, const std::string& type);
/// The name that the table at index `table` gives, or `spare`.
std::string given_name(lua_State* state, int table, const std::string& spare);
/// A finding for each entry whose key is no text.
void refuse_odd_keys(lua_State* state, int table, const std::string& owner);
/// The thread that the table at index `table` names, or the present one.
ThreadId thread_given(lua_State* state, int table);
// Methods of outputs, for a connection to another thread.
int output_latest(lua_State* state);
int output_queue(lua_State* state);
/// Adds to a reference's metatable what all have: a text, and the refusal of assignments.
void complete_metatable(lua_State* state, const char* metatable);
/// Applies one entry of a constructor's table: key, and the value at the top of the stack.
void apply_entry(lua_State* state, NodeId node, const std::string& key);

}  // namespace trocar::lua
