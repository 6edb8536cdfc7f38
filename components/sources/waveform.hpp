// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"

namespace trocar {

/// A source of one number over time, in the unit that its parameters are written in.
class Waveform : public Component {
 public:
  std::optional<Signature> natural_signature() const override;

  GenericOutput value{this, "value", {.doc = "the signal, in the unit of its parameters"}};

 protected:
  /// The parameter that says in which unit the signal is.
  virtual const Parameter<Quantity>& scale() const = 0;
  /// @throw std::invalid_argument when the output is wired to something of another type or unit.
  void require_own_unit() const;
  /// A parameter in the unit of scale(); zero needs none.
  /// @throw std::invalid_argument when it is in another.
  double in_own_unit(const Parameter<Quantity>& parameter) const;
};

}  // namespace trocar
