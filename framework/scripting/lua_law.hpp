// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "framework/scripting/law_file.hpp"
#include "framework/scripting/law_shim.hpp"
#include "framework/scripting/law_state.hpp"
#include "framework/scripting/loop_state.hpp"
#include "framework/scripting/output_ramp.hpp"
#include "framework/tick.hpp"

namespace trocar::lua {

/// Where the values of a law's ports lie, in the order in which its file has them.
struct LawMemory {
  std::vector<const std::byte*> inputs{};
  std::vector<std::byte*> outputs{};
  std::vector<ParameterBase*> parameters{};  // those that the file declares
};

/// A law ready to step: its file, compiled in a Lua state of its own, and bound to the memory of a
/// component. It can be built aside, while another one steps.
///
/// A step has two halves: evaluate() reads inputs and parameters, calls the script, and keeps what
/// it says when all of it is right and in time; commit() writes the outputs. It allocates nothing
/// but what the script does, from the law's own pool; only the way out of an error takes memory (a
/// C++ exception), once.
class LuaLaw {
 public:
  /// @throw std::invalid_argument with the reason, where it cannot be
  LuaLaw(const LawFile& file, const LoopLimits& limits, std::uint64_t seed, LawMemory memory);

  /// @return false where the step failed: error() says why. It is not to be called again.
  bool evaluate(const Tick& tick) RT_SAFE;
  /// Writes what evaluate() found.
  void commit() RT_SAFE;
  /// The same, with a ramp's numbers added.
  void commit(const OutputRamp& ramp) RT_SAFE;
  /// Both halves. @return false where the step failed, and nothing was written
  bool step(const Tick& tick) RT_SAFE {
    const bool right = evaluate(tick);
    if (right) commit();
    return right;
  }

  /// A number of its outputs, as evaluate() found it; 0 for those that are not real.
  double found(std::size_t number) const RT_SAFE { return outputs_[number].real; }
  const std::vector<LawNumber>& output_numbers() const { return shim_->outputs; }
  /// Its script's state.
  const LawState& kept() const RT_SAFE { return kept_; }
  /// With other versions, on where the numbers of the state stand.
  void agree(std::vector<std::string>& state_names) { kept_.agree(state_names); }
  /// From now on parameters are read there: the same ones, of another component.
  void follow(const std::vector<ParameterBase*>& parameters);
  /// What is left to do when there is time: a part of the collector's work.
  void use_slack() RT_SAFE { state_.collect(); }

  /// "membrane.lua:12: what, and the cure; called at line 30"
  const char* error() const RT_SAFE { return state_.error(); }
  std::int64_t allocations() const RT_SAFE { return state_.guard().allocations(); }
  std::size_t memory() const RT_SAFE { return state_.guard().memory(); }

 private:
  struct Input {
    LawNumber::Kind kind;
    const std::byte* at;
  };
  struct Value {  // a number on its way out
    LawNumber::Kind kind;
    std::byte* at;
    double real;
    std::int64_t whole;
  };
  /// A parameter's number, and as Lua has it.
  struct Known {
    const double* now;
    double told;
    const ParameterBase* parameter;
  };

  void load();
  void push_labels();
  void push_parameter(const ParameterBase& parameter);
  void follow_parameters() RT_SAFE;
  void tell(const ParameterBase& parameter) RT_SAFE;
  int push_arguments(const Tick& tick) RT_SAFE;
  void push_other(const Input& input) RT_SAFE;
  bool read_outputs() RT_SAFE;
  bool read_other(Value& value, int index) RT_SAFE;
  void refuse(const LawNumber& number, int index) RT_SAFE;
  static void write(const Value& value, double real) RT_SAFE;

  const LawFile& file_;
  LawMemory memory_;
  LoopState state_;
  std::unique_ptr<LawShim> shim_;
  std::vector<Input> inputs_;
  std::vector<Value> outputs_;
  std::vector<Known> known_;
  LawState kept_;
};

}  // namespace trocar::lua
