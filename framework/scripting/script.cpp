// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/script.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "framework/scripting/world.hpp"
#include "framework/text.hpp"

namespace trocar {
namespace lua {

std::string ScriptContext::unused_name(const std::string& stem) {
  return unused_name(stem, scope());
}

std::string ScriptContext::unused_name(const std::string& stem, const std::string& inside) {
  return graph().unused_name(stem, inside);
}

Finding finding_of(const std::string& script, const std::string& message) {
  const std::size_t first = message.starts_with(script + ":") ? script.size() : message.find(':');
  const std::size_t second = first == std::string::npos ? first : message.find(':', first + 1);
  int line = 0;
  if (second != std::string::npos)
    std::from_chars(message.data() + first + 1, message.data() + second, line);
  if (line <= 0) return {{}, message};
  std::string file = message.substr(0, first);
  if (file.starts_with("...") && script.ends_with(file.substr(3))) file = script;  // Lua's short
  const std::string place = message.substr(0, second + 1);
  std::string_view what = trim(std::string_view(message).substr(second + 1));
  while (what.starts_with(place)) what = trim(what.substr(place.size()));  // said once is enough
  return {{file, line}, std::string(what)};
}

std::string script_text(const std::string& path) {
  if (const auto text = read_file(path)) return *text;
  Findings unreadable;
  unreadable.add({path, 0}, "there is no script that can be read");
  throw BrokenGraph(unreadable);
}

namespace {

/// Whether the script was ended before its last line, having described or run enough.
bool stopped_on_purpose(const ScriptContext& script) {
  return script.stopped || (script.session.options().check_only && script.ran);
}

void report_unused_arguments(ScriptContext& script) {
  if (stopped_on_purpose(script)) return;  // it might have asked later
  for (const auto& [key, argument] : script.arguments)
    if (!argument.used)
      script.graph().finding(argument.where,
                             fmt::format("the script never asks for trocar.args.{}{}", key,
                                         suggestion(key, script.asked)));
}

void execute(ScriptContext& script, const std::string& path, const std::string& code) {
  World world(script);
  const auto error = world.run_text(path, code);
  if (!error || stopped_on_purpose(script)) return;
  if (script.broken && error->find(script.broken->text()) != std::string::npos)
    throw BrokenGraph(*script.broken);
  const Finding finding = finding_of(path, *error);
  script.graph().finding(finding.where, finding.message);
}

}  // namespace
}  // namespace lua

void run_script(Session& session, const std::string& path, Graph::Overrides arguments) {
  const std::string text = lua::script_text(path);
  session.add_script(std::filesystem::path(path).filename().string(), text);
  lua::ScriptContext script{session, std::move(arguments),
                            std::filesystem::path(path).parent_path()};
  lua::execute(script, path, text);

  lua::report_unused_arguments(script);
  if (!script.ran || session.options().check_only) session.graph().report_unused_overrides();
  if (session.options().check_only || !session.graph().findings().empty()) {
    if (const Findings findings = check(session.graph(), session.first_wiring()); !findings.empty())
      throw BrokenGraph(findings);
    return;
  }
  if (!script.ran) session.run({});
}

}  // namespace trocar
