// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/spec.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "framework/scripting/spec_context.hpp"
#include "framework/scripting/world.hpp"
#include "framework/text.hpp"

namespace trocar {
namespace lua {
namespace {

/// A spec file that was read once, with all that it needs to run one of its tests.
class SpecFile {
 public:
  SpecFile(const Registry& registry, const std::string& path, const SpecOptions& options,
           std::optional<std::size_t> wanted)
      : path_(path),
        session_(registry, session_options(options)),
        script_{session_, {}, std::filesystem::path(path).parent_path()} {
    spec_.wanted = wanted;
    script_.spec = &spec_;
    const std::string text = script_text(path);
    world_.emplace(script_);
    if (const auto error = world_->run_text(path, text)) {
      const Finding finding = finding_of(path, *error);
      session_.graph().finding(finding.where, finding.message);
    }
    if (const Findings& found = session_.graph().findings(); !found.empty())
      throw BrokenGraph(found);
  }

  std::vector<SpecTest> tests() { return std::move(spec_.tests); }

  std::vector<SpecFailure> run() {
    if (spec_.body == LUA_NOREF)
      throw std::invalid_argument(fmt::format("{} has no such test", path_));
    const Where at = spec_.tests[*spec_.wanted].where;
    for (const auto& level : spec_.around_body)
      for (const int function : level->before) call(function);
    spec_.testing = true;
    if (spec_.failures.empty()) call(spec_.body);
    add_unseen_faults(at);
    if (spec_.failures.empty() && spec_.expectations == 0)
      spec_.failures.push_back({.where = at, .message = "the test expects nothing"});
    return std::move(spec_.failures);
  }

 private:
  static SessionOptions session_options(const SpecOptions& options) {
    SessionOptions session;
    session.clock = ClockKind::simulated;
    session.seed = options.seed;
    session.stop = options.stop;
    session.write_files = false;
    return session;
  }

  void call(int function) {
    lua_rawgeti(world_->state(), LUA_REGISTRYINDEX, function);
    const auto error = world_->call();
    if (error && spec_.failures.empty()) {
      const Finding finding = finding_of(path_, *error);
      spec_.failures.push_back({.where = finding.where, .message = finding.message});
    }
    // What was built or loaded wrongly; a run would have said so itself.
    if (spec_.failures.empty())
      for (const Finding& finding : session_.graph().findings().all())
        spec_.failures.push_back({.where = finding.where, .message = finding.message});
  }

  /// A test that passes while its device trips would be worth nothing.
  void add_unseen_faults(const Where& at) {
    const auto look = [&](const Session& session) {
      for (const auto& run : session.runs())
        if (!run->result.faults.empty() && !script_.faults_looked_at.contains(&run->result))
          spec_.failures.push_back(
              {.where = at,
               .message =
                   fmt::format("a run had a fault, and the test never looked at its `faults`: {}",
                               run->result.faults.front().text())});
    };
    look(session_);
    for (const auto& rig : script_.rigs) look(*rig);
  }

  std::string path_;
  Session session_;
  ScriptContext script_;
  SpecContext spec_;
  std::optional<World> world_;
};

// --- what a spec file calls -------------------------------------------------------------------

SpecContext& spec_of(lua_State* state) {
  return *context(state).spec;
}

void need_name_and_function(lua_State* state, const char* function) {
  if (lua_type(state, 1) == LUA_TSTRING && lua_isfunction(state, 2)) return;
  throw std::invalid_argument(fmt::format(
      "{0} takes a name and a function: {0}(\"tears once\", function() … end)", function));
}

void refuse_inside_a_test(lua_State* state, const char* function) {
  if (spec_of(state).testing)
    throw std::invalid_argument(fmt::format("{} is for the outside of a test", function));
}

int describe(lua_State* state) {
  need_name_and_function(state, "describe");
  refuse_inside_a_test(state, "describe");
  SpecContext& spec = spec_of(state);
  spec.levels.push_back(std::make_shared<SpecContext::Level>(
      SpecContext::Level{std::string(lua_tostring(state, 1)), {}}));
  lua_settop(state, 2);
  lua_call(state, 0, 0);  // an error ends the whole file
  spec.levels.pop_back();
  return 0;
}

int it(lua_State* state) {
  need_name_and_function(state, "it");
  refuse_inside_a_test(state, "it");
  SpecContext& spec = spec_of(state);
  std::vector<std::string> names;
  for (const auto& level : spec.levels)
    if (!level->name.empty()) names.push_back(level->name);
  names.emplace_back(lua_tostring(state, 1));
  if (spec.wanted == spec.tests.size()) {
    lua_settop(state, 2);
    spec.body = luaL_ref(state, LUA_REGISTRYINDEX);
    spec.around_body = spec.levels;
  }
  spec.tests.push_back({join(names, ": "), where(state)});
  return 0;
}

int before_each(lua_State* state) {
  if (!lua_isfunction(state, 1))
    throw std::invalid_argument("before_each takes a function: before_each(function() … end)");
  refuse_inside_a_test(state, "before_each");
  lua_settop(state, 1);
  spec_of(state).levels.back()->before.push_back(luaL_ref(state, LUA_REGISTRYINDEX));
  return 0;
}

}  // namespace

void open_specs(lua_State* state) {
  lua_pushcfunction(state, guarded<describe>);
  lua_setglobal(state, "describe");
  lua_pushcfunction(state, guarded<it>);
  lua_setglobal(state, "it");
  lua_pushcfunction(state, guarded<before_each>);
  lua_setglobal(state, "before_each");
  open_expect(state);
}

}  // namespace lua

std::string SpecFailure::text() const {
  std::string text = where.text();
  if (!message.empty()) text += fmt::format(": {}", message);
  if (!expected.empty()) text += fmt::format("\n  expected  {}\n  got       {}", expected, got);
  if (!plot.empty()) text += "\n" + plot;
  return text;
}

std::vector<SpecTest> list_spec(const Registry& registry, const std::string& path) {
  return lua::SpecFile(registry, path, {}, std::nullopt).tests();
}

std::vector<SpecFailure> run_spec(const Registry& registry, const std::string& path,
                                  std::size_t index, const SpecOptions& options) {
  return lua::SpecFile(registry, path, options, index).run();
}

}  // namespace trocar
