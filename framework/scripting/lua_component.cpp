// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/lua_component.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trocar::lua {
namespace {

constexpr double share_of_period = 0.2;  // that a step may take where nobody says another
constexpr double history_time = 2.0;     // [s] on which a new version is tried
constexpr double ramp_time = 0.2;        // [s] as of a live edit
constexpr double probation_time = 1.0;   // [s]
constexpr double lever = 0.1;            // [m] by which a moment counts as a force

std::int64_t steps_of(double time, double period) {
  return std::max<std::int64_t>(1, std::llround(time / period));
}

}  // namespace

LuaComponent::LuaComponent(std::shared_ptr<const LawFile> file) : file_(std::move(file)) {
  for (const LawPort& port : file_->inputs)
    inputs_.emplace_back(this, port.name, *port.type, port.options());
  for (const LawPort& port : file_->outputs)
    outputs_.emplace_back(this, port.name, *port.type, port.options());
  for (const DeclaredParameter& parameter : file_->parameters) {
    declared_.declare(*this, parameter, true);
    of_the_file_.push_back(parameters().back());
  }
  if (file_->kind != LawKind::fixture) return;
  auto* moment = find_output("moment");
  const bool renders = moment != nullptr && moment->signature()->type == &type_info<Vector3>();
  place({.position = find_input("position"),
         .velocity = find_input("velocity"),
         .force = find_output("force"),
         .moment = renders ? moment : nullptr});
}

LoopLimits LuaComponent::limits() const {
  const double deadline = *deadline_ > 0.0 ? *deadline_ : share_of_period * setup_.period;
  return {.memory = static_cast<std::size_t>(*memory_) * 1024,
          .instructions = *instructions_,
          .deadline_ns = setup_.virtual_time ? 0 : std::llround(deadline * 1e9),
          .strict = *strict_,
          .whole_cycles = setup_.virtual_time};
}

LawMemory LuaComponent::ports() {
  LawMemory memory;
  for (const AnyInput& input : inputs_) memory.inputs.push_back(input.value());
  for (AnyOutput& output : outputs_) memory.outputs.push_back(output.value());
  memory.parameters = of_the_file_;
  return memory;
}

void LuaComponent::configure(const Setup& setup) {
  setup_ = setup;
  first_ = std::make_unique<LawVersion>(
      file_, std::make_unique<LuaLaw>(*file_, limits(), setup.seed, ports()));
  first_->law().agree(state_names_);
  change_.begin(*first_, {.ramp_steps = steps_of(ramp_time, setup.period),
                          .probation_steps = steps_of(probation_time, setup.period),
                          .force = *reload_limit_,
                          .moment = *reload_limit_ * lever});
  if (setup.reloadable) begin_history();
}

void LuaComponent::begin_history() {
  LawHistory::Shape shape;
  for (ParameterBase* parameter : of_the_file_) shape.parameters += parameter->numbers().size();
  for (const LawPort& port : file_->inputs) shape.inputs.push_back(port.type->size);
  history_.emplace(std::move(shape),
                   static_cast<std::size_t>(steps_of(history_time, setup_.period)));
}

void LuaComponent::start() {
  *held_ = static_cast<std::int64_t>(change_.law().memory());
}

void LuaComponent::remember(const Tick& tick) RT_SAFE {
  change_.law().kept().read(remembered_state_);
  LawHistory::Writer writer(*history_);
  writer.put(&tick, sizeof tick);
  writer.put(&remembered_state_, sizeof remembered_state_);
  for (ParameterBase* parameter : of_the_file_)
    for (const double& number : parameter->numbers()) writer.put(&number, sizeof number);
  for (std::size_t i = 0; i < inputs_.size(); ++i)
    writer.put(inputs_[i].value(), history_->shape().inputs[i]);
}

void LuaComponent::step(const Tick& tick) RT_SAFE {
  if (history_) remember(tick);
  const bool right = change_.step(tick);
  *allocations_ = change_.law().allocations();
  *held_ = static_cast<std::int64_t>(change_.law().memory());
  if (!right) fail(change_.law().error());
}

void LuaComponent::use_slack() RT_SAFE {
  if (failure() == nullptr) change_.law().use_slack();
}

std::unique_ptr<ComponentType> law_type(std::shared_ptr<const LawFile> file) {
  const bool fixture = file->kind == LawKind::fixture;
  auto type = std::make_unique<ComponentType>();
  type->name = fixture ? "LuaFixture" : "LuaComponent";
  type->category = fixture ? "fixtures" : "control";
  type->doc = fmt::format("A {} in Lua: {}", fixture ? "fixture" : "component", file->name);
  type->make = [file = std::move(file)] { return std::make_unique<LuaComponent>(file); };
  return type;
}

}  // namespace trocar::lua
