// SPDX-License-Identifier: Apache-2.0
#include "framework/run_control.hpp"

#include <fmt/format.h>

#include <unordered_map>

#include "framework/clock.hpp"
#include "framework/edit_schedule.hpp"
#include "framework/text.hpp"

namespace trocar {

/// The same graph wired once more, which nobody runs: values are read by its parameters' rules,
/// since those of the live graph belong to the loop.
struct RunControl::Twin {
  Twin(const Graph& graph, const WiringOptions& options, const WiredGraph& live)
      : wired(wire(graph, options)) {
    for (std::size_t group = 0; group < live.groups().size(); ++group) {
      const auto& here = wired->groups()[group].schedule();
      const auto& there = live.groups()[group].schedule();
      for (std::size_t i = 0; i < here.size(); ++i) {
        const auto& own = here[i].component->parameters();
        const auto& others = there[i].component->parameters();
        for (std::size_t k = 0; k < own.size(); ++k)
          of_live[own[k]] = {others[k], there[i].component->name().c_str()};
      }
    }
  }

  struct Counterpart {
    ParameterBase* parameter = nullptr;
    const char* owner = "";
  };
  std::unique_ptr<WiredGraph> wired;
  std::unordered_map<const ParameterBase*, Counterpart> of_live;
};

RunControl::RunControl(const Graph& graph, const WiringOptions& options, const WiredGraph& live,
                       std::deque<CommandQueue>& queues, Reloads& reloads)
    : graph_(graph),
      options_(options),
      live_(live),
      queues_(queues),
      reloads_(reloads),
      waiting_(queues.size()) {}

RunControl::~RunControl() = default;

RunControl::Twin& RunControl::twin() {
  if (!twin_) twin_ = std::make_unique<Twin>(graph_, options_, live_);
  return *twin_;
}

void RunControl::request(Command::Kind kind) {
  for (std::deque<Command>& commands : waiting_) commands.push_back({.kind = kind});
  flush();
}

void RunControl::set(const std::string& key, const Literal& value) {
  Twin& own = twin();
  auto commands = schedule_edits({Edit{.at = 0.0, .key = key, .value = value, .where = {}}}, graph_,
                                 *own.wired);
  for (std::size_t group = 0; group < commands.size(); ++group)
    for (Command& command : commands[group]) {
      command.parameter->set(value);
      const Twin::Counterpart& live = own.of_live.at(command.parameter);
      command.parameter = live.parameter;
      command.owner = live.owner;
      waiting_[group].push_back(command);
    }
  flush();
}

void RunControl::annotate(std::string text) {
  remarks_.push_back(std::move(text));
  waiting_.front().push_back({.kind = Command::Kind::annotate, .text = remarks_.back().c_str()});
  flush();
}

std::string RunControl::reload(Reload reload) {
  return this->reload(reloads_.issue(std::move(reload)));
}

std::string RunControl::reload(const Reloads::Issued& issued) {
  issued.ticket->prepare(time());
  waiting_[issued.group].push_back({.kind = Command::Kind::replace, .ticket = issued.ticket});
  flush();
  return issued.ticket->trouble();
}

void RunControl::begin() {
  if (!begin_ns_) begin_ns_ = monotonic_ns();
}

double RunControl::time() const {
  return begin_ns_ ? 1e-9 * static_cast<double>(monotonic_ns() - *begin_ns_) : 0.0;
}

std::string RunControl::text(const std::string& key) {
  const std::size_t dot = std::min(key.rfind('.'), key.size());
  const Component* component = twin().wired->find(key.substr(0, dot));
  if (component != nullptr && dot < key.size())
    for (const ParameterBase* parameter : component->parameters())
      if (parameter->name() == key.substr(dot + 1)) {
        const std::string range = parameter->range_text();
        return parameter->text() + (range.empty() ? "" : fmt::format(" ({})", range));
      }
  Findings findings;
  findings.add(
      {}, fmt::format("nothing is called \"{}\"{}", key, suggestion(key, graph_.parameter_keys())));
  throw BrokenGraph(findings);
}

std::vector<ParameterState> RunControl::parameters() {
  std::vector<ParameterState> all;
  for (const RateGroup& group : twin().wired->groups())
    for (const ScheduleItem& item : group.schedule())
      for (ParameterBase* parameter : item.component->parameters()) {
        ParameterState one{.key = item.component->name() + "." + parameter->name(),
                           .text = parameter->assigned() ? parameter->text() : "",
                           .unit = parameter->shown_unit(),
                           .min = parameter->min(),
                           .max = parameter->max(),
                           .doc = parameter->doc(),
                           .choices = parameter->choices(),
                           .live = parameter->live() && !parameter->numbers().empty()};
        const std::span<const double> numbers = parameter->numbers();
        one.numbers.assign(numbers.begin(), numbers.end());
        all.push_back(std::move(one));
      }
  return all;
}

std::vector<std::string> RunControl::live_keys() {
  std::vector<std::string> keys;
  for (ParameterState& one : parameters())
    if (one.live) keys.push_back(std::move(one.key));
  return keys;
}

bool RunControl::flush() {
  bool waits = false;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    std::deque<Command>& commands = waiting_[i];
    while (!commands.empty() && queues_[i].try_push(commands.front())) commands.pop_front();
    waits = waits || !commands.empty();
  }
  return waits;
}

}  // namespace trocar
