// SPDX-License-Identifier: Apache-2.0
#include "framework/edit_schedule.hpp"

#include <fmt/format.h>

#include <cmath>

#include "framework/text.hpp"

namespace trocar {
namespace {

constexpr const char* not_live = "cannot be edited while it runs";

/// The numbers that a value stands for, by the parameter's own rules; the parameter keeps its own.
std::array<double, max_axes> numbers_of(ParameterBase& parameter, const Literal& value,
                                        std::string& wrong) {
  std::array<double, max_axes> numbers{};
  const std::any kept = parameter.save();
  wrong = parameter.set(value);
  const std::span<double> now = parameter.numbers();
  std::copy(now.begin(), now.end(), numbers.begin());
  parameter.restore(kept);
  return numbers;
}

/// Where a parameter's component runs.
struct Owner {
  std::size_t group = 0;
  const char* name = "";
};

Owner owner_of(const ParameterBase& parameter, const WiredGraph& wired) {
  for (std::size_t group = 0; group < wired.groups().size(); ++group)
    for (const ScheduleItem& item : wired.groups()[group].schedule())
      for (const ParameterBase* own : item.component->parameters())
        if (own == &parameter) return {group, item.component->name().c_str()};
  return {};
}

void refuse(const Edit& edit, const std::string& why, Findings& findings) {
  findings.add(edit.where, fmt::format("{} = {}: {}", edit.key, edit.value.text(), why));
}

std::vector<ParameterBase*> moved_by(const Edit& edit, const Graph& graph, const WiredGraph& wired,
                                     Findings& findings) {
  const std::size_t dot = std::min(edit.key.rfind('.'), edit.key.size());
  const auto node = graph.find(edit.key.substr(0, dot));
  const std::string name = dot < edit.key.size() ? edit.key.substr(dot + 1) : "";
  if (!node || graph.node(*node).settings().find_parameter(name) == nullptr) {
    findings.add(edit.where, fmt::format("nothing is called \"{}\"{}", edit.key,
                                         suggestion(edit.key, graph.parameter_keys())));
    return {};
  }
  const std::vector<ParameterBase*> moved = wired.followers(graph, {*node, name});
  if (moved.empty()) refuse(edit, not_live, findings);
  return moved;
}

}  // namespace

std::vector<std::vector<Command>> schedule_edits(const std::vector<Edit>& edits, const Graph& graph,
                                                 const WiredGraph& wired) {
  Findings findings;
  std::vector<std::vector<Command>> commands(wired.groups().size());
  for (const Edit& edit : edits)
    for (ParameterBase* parameter : moved_by(edit, graph, wired, findings)) {
      std::string wrong;
      if (!parameter->live() || parameter->numbers().empty()) wrong = not_live;
      const Owner owner = owner_of(*parameter, wired);
      Command command{.kind = Command::Kind::set_parameter,
                      .not_before = std::llround(edit.at / wired.groups()[owner.group].period()),
                      .parameter = parameter,
                      .owner = owner.name,
                      .target = {}};
      if (wrong.empty()) command.target = numbers_of(*parameter, edit.value, wrong);
      if (wrong.empty())
        commands[owner.group].push_back(command);
      else
        refuse(edit, wrong, findings);
    }
  if (!findings.empty()) throw BrokenGraph(findings);
  return commands;
}

}  // namespace trocar
