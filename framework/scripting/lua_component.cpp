// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/lua_component.hpp"

#include <fmt/format.h>

#include <cmath>

namespace trocar::lua {
namespace {

constexpr double share_of_period = 0.2;  // that a step may take where nobody says another

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

LoopLimits LuaComponent::limits(const Setup& setup) const {
  const double deadline = *deadline_ > 0.0 ? *deadline_ : share_of_period * setup.period;
  return {.memory = static_cast<std::size_t>(*memory_) * 1024,
          .instructions = *instructions_,
          .deadline_ns = setup.virtual_time ? 0 : std::llround(deadline * 1e9),
          .strict = *strict_,
          .whole_cycles = setup.virtual_time};
}

void LuaComponent::configure(const Setup& setup) {
  LawMemory memory;
  for (const AnyInput& input : inputs_) memory.inputs.push_back(input.value());
  for (AnyOutput& output : outputs_) memory.outputs.push_back(output.value());
  memory.parameters = of_the_file_;
  law_ = std::make_unique<LuaLaw>(*file_, limits(setup), setup.seed, std::move(memory));
}

void LuaComponent::start() {
  *held_ = static_cast<std::int64_t>(law_->memory());
}

void LuaComponent::step(const Tick& tick) RT_SAFE {
  const bool right = law_->step(tick);
  *allocations_ = law_->allocations();
  *held_ = static_cast<std::int64_t>(law_->memory());
  if (!right) fail(law_->error());
}

void LuaComponent::use_slack() RT_SAFE {
  if (failure() == nullptr) law_->use_slack();
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
