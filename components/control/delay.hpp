// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"

namespace trocar {

/// value_k = input_{k-n}, and `initial` for k < n: what a loop needs to be one. It counts its own
/// steps, whether its producer steps before it in a tick or, in a loop, after it. Inside a loop
/// the producer's quality is not known when this is configured, and counts as exact.
class Delay final : public Component {
 public:
  std::optional<Signature> natural_signature() const override;
  /// @throw std::invalid_argument when `initial` is not what it is wired to.
  void configure(const Setup& setup) override;
  void start() override;
  void step(const Tick& tick) RT_SAFE override;

  GenericInput input{this, "input", {.doc = "what is delayed", .feedthrough = false}};
  GenericOutput value{this, "value", {.doc = "the input, so many ticks ago"}};
  Parameter<std::int64_t> ticks{
      this,
      "ticks",
      {.initial = "1", .min = "1", .max = "100000", .doc = "n, in steps of this component"}};
  Parameter<Literal> initial{this, "initial", {.doc = "the value until there is an input"}};

 private:
  void store() RT_SAFE;  // the input in place of the oldest
  void recall() RT_SAFE;

  std::vector<double> past_;  // ring of n values
  std::vector<double> initial_;
  std::size_t oldest_ = 0;  // [numbers]
  bool started_ = false;
};

}  // namespace trocar
