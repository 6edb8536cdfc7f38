// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/parameter_set.hpp"
#include "framework/port.hpp"
#include "framework/tick.hpp"

namespace trocar {

/// Which of a component's ports `at = site` wires.
struct Placement {
  enum class Acts {
    through_motors,  // a force to render
    on_tool          // an external load: a weight, a hand
  };
  InputPort* position = nullptr;
  InputPort* velocity = nullptr;
  OutputPort* force = nullptr;
  OutputPort* moment = nullptr;
  Acts acts = Acts::through_motors;
};

/// A node of the dataflow graph. A subclass declares its inputs, outputs and parameters as
/// members; script binding, checks, help and logs all follow from those declarations.
///
/// Lifecycle: constructed → parameters set → wired → configure → start → step … step → stop.
/// configure() runs in the order of the schedule, so what feeds a component is configured before
/// it. A component is built anew for each run.
class Component : public ParameterSet {
 public:
  const std::string& name() const { return name_; }
  void set_name(std::string_view name) { name_ = name; }
  const std::vector<InputPort*>& inputs() const { return inputs_; }
  const std::vector<OutputPort*>& outputs() const { return outputs_; }
  InputPort* find_input(std::string_view name) const;
  OutputPort* find_output(std::string_view name) const;
  const std::optional<Placement>& placement() const { return placement_; }

  /// Spreads what is known of its generic ports among them; by default they are all alike.
  virtual void unify();
  /// What a generic output is when nothing that it is wired to says so.
  virtual std::optional<Signature> natural_signature() const { return std::nullopt; }

  /// Prepares for a run; may allocate.
  /// @throw std::invalid_argument with the reason when it cannot run as it is set.
  virtual void configure(const Setup&) {}
  /// Gives the outputs their values before the first tick.
  virtual void start() {}
  /// One tick: reads the inputs, writes the outputs.
  virtual void step(const Tick& tick) RT_SAFE = 0;
  virtual void stop() {}
  /// Says that it makes a signal of how long its steps take.
  virtual bool wants_duration() const { return false; }
  /// After each step where the loop measures in real time.
  virtual void take_duration(std::int64_t /*ns*/) RT_SAFE {}
  /// Says that it has work for the time between two ticks, when efforts and rows are sent.
  virtual bool wants_slack() const { return false; }
  /// A bounded part of that work. It comes after a tick, and not after each: a tick that took
  /// more than half its period leaves none.
  virtual void use_slack() RT_SAFE {}

  /// Why it gave up, or null. The executor looks after each step.
  const char* failure() const RT_SAFE { return failure_; }

  void add(InputPort* port) { inputs_.push_back(port); }
  void add(OutputPort* port) { outputs_.push_back(port); }
  using ParameterSet::add;

 protected:
  /// Says that its outputs are not to be used from now on. It is stepped no more; a force that it
  /// renders at a site may only resist from then on.
  void fail(const char* reason) RT_SAFE { failure_ = reason; }
  /// Declares the ports that `at = site` wires.
  void place(const Placement& placement) { placement_ = placement; }

 private:
  std::string name_;
  std::vector<InputPort*> inputs_;
  std::vector<OutputPort*> outputs_;
  std::optional<Placement> placement_;
  const char* failure_ = nullptr;
};

}  // namespace trocar
