// SPDX-License-Identifier: Apache-2.0
// How another version of a law is made ready, beside the one that runs.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "framework/clock.hpp"
#include "framework/scripting/lua_component.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

constexpr double share_in_time = 0.99;  // of the steps on which a version is tried

[[noreturn]] void refuse(const LawFile& file, const std::string& why) {
  throw std::invalid_argument(file.name + ": " + why);
}

/// Ports belong to the wiring, which stays as it is.
void check_ports(const LawFile& file, const char* kind, const std::vector<LawPort>& now,
                 const std::vector<LawPort>& next) {
  const auto described = [](const LawPort& port) {
    return fmt::format("{} {} [{}] {} {} {}", port.name, port.type->name, port.si_unit, port.frame,
                       port.axes, join(port.labels, " "));
  };
  const auto missing_in = [&](const std::vector<LawPort>& one, const std::vector<LawPort>& other) {
    return std::find_if(one.begin(), one.end(), [&](const LawPort& port) {
      return std::none_of(other.begin(), other.end(), [&](const LawPort& candidate) {
        return described(candidate) == described(port);
      });
    });
  };
  if (const auto gone = missing_in(now, next); gone != now.end())
    refuse(file, fmt::format("the {} \"{}\" has gone or changed, but is wired: end the run, and "
                             "begin anew",
                             kind, gone->name));
  if (const auto added = missing_in(next, now); added != next.end())
    refuse(file, fmt::format("the {} \"{}\" is new, and nothing is wired to it: end the run, and "
                             "begin anew",
                             kind, added->name));
}

/// The parameter of that name and type, or null.
ParameterBase* same_parameter(const std::vector<ParameterBase*>& among,
                              const ParameterBase& wanted) {
  const auto found = std::find_if(among.begin(), among.end(), [&](const ParameterBase* one) {
    return one->name() == wanted.name() && one->type_name() == wanted.type_name() &&
           one->unit().dimension == wanted.unit().dimension;
  });
  return found == among.end() ? nullptr : *found;
}

}  // namespace

std::vector<ParameterBase*> LuaComponent::same_parameters(const LuaComponent& next) const {
  std::vector<ParameterBase*> same;
  for (const ParameterBase* parameter : next.of_the_file_) {
    same.push_back(same_parameter(of_the_file_, *parameter));
    if (same.back() == nullptr)
      refuse(*next.file_, fmt::format("the parameter \"{}\" is new, or of another type: end the "
                                      "run, and begin anew",
                                      parameter->name()));
  }
  return same;
}

/// What is no live number does not change while it runs, so it can be read from outside.
void LuaComponent::copy_settings(const LuaComponent& other) {
  for (ParameterBase* parameter : parameters())
    if (const ParameterBase* same = same_parameter(other.parameters(), *parameter);
        same != nullptr && !same->live())
      parameter->copy_from(*same);
}

/// @param before the parameters whose numbers the step has
void LuaComponent::recall(const LawHistory::Step& step, const std::vector<ParameterBase*>& before) {
  const double* numbers = step.parameters.data();
  for (ParameterBase* parameter : before) {
    const std::size_t count = parameter->numbers().size();
    if (ParameterBase* own = same_parameter(of_the_file_, *parameter))
      std::copy_n(numbers, count, own->numbers().begin());
    numbers += count;
  }
  for (std::size_t i = 0; i < inputs_.size(); ++i)
    std::memcpy(inputs_[i].own(), step.inputs[i].data(), step.inputs[i].size());
}

/// On what the other one has seen: it has to be right, and in time.
void LuaComponent::try_on(const std::vector<LawHistory::Step>& steps, const LuaComponent& other) {
  std::vector<std::int64_t> times;
  change_.law().kept().write(steps.front().state);
  for (const LawHistory::Step& step : steps) {
    recall(step, other.of_the_file_);
    const std::int64_t begin = monotonic_ns();
    const bool right = change_.step(step.tick);
    times.push_back(monotonic_ns() - begin);
    change_.law().use_slack();
    if (!right)
      throw std::invalid_argument(
          fmt::format("{} (on what it saw at tick {})", change_.law().error(), step.tick.index));
  }
  const std::int64_t deadline = other.limits().deadline_ns;
  if (deadline == 0) return;
  std::sort(times.begin(), times.end());
  const auto place =
      static_cast<std::size_t>(share_in_time * static_cast<double>(times.size() - 1));
  if (times[place] > deadline)
    refuse(*file_, fmt::format("took {:.1f} us for its slower steps, of its {:.1f} us: shorten it, "
                               "or raise \"deadline\"",
                               1e-3 * static_cast<double>(times[place]),
                               1e-3 * static_cast<double>(deadline)));
}

std::unique_ptr<Replacement> LuaComponent::prepare(const Reload& reload) {
  Findings findings;
  auto file = read_law(file_->kind, std::filesystem::path(reload.path).filename().string(),
                       reload.path, reload.text, findings);
  if (!file) throw std::invalid_argument(findings.by_line().text());
  check_ports(*file, "input", file_->inputs, file->inputs);
  check_ports(*file, "output", file_->outputs, file->outputs);
  if (!history_) refuse(*file, "this run was begun without reloads");
  const std::vector<LawHistory::Step> steps = history_->steps();
  if (steps.empty()) refuse(*file, "the law in charge has not made a step yet");

  LuaComponent trial(file);  // wired to nobody
  const std::vector<ParameterBase*> live = same_parameters(trial);
  trial.set_name(name());
  trial.copy_settings(*this);
  trial.recall(steps.front(), of_the_file_);
  Setup setup = setup_;
  setup.virtual_time = true;  // its thread may have to wait for the loop's: time is looked at here
  setup.reloadable = false;
  trial.configure(setup);
  trial.change_.law().agree(state_names_);
  trial.try_on(steps, *this);

  LawMemory memory = ports();
  memory.parameters = trial.of_the_file_;  // the live ones belong to the loop
  auto law = std::make_unique<LuaLaw>(*file, limits(), setup_.seed, std::move(memory));
  law->agree(state_names_);
  law->follow(live);
  return std::make_unique<LawVersion>(std::move(file), std::move(law));
}

void LuaComponent::replace(Replacement& next) RT_SAFE {
  change_.replace(static_cast<LawVersion&>(next));
}

}  // namespace trocar::lua
