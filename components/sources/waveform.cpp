// SPDX-License-Identifier: Apache-2.0
#include "components/sources/waveform.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "components/signal.hpp"

namespace trocar {

std::optional<Signature> Waveform::natural_signature() const {
  return real_signal(scale()->unit);
}

void Waveform::require_own_unit() const {
  const Signature own = real_signal(scale()->unit);
  const bool zero = scale()->value == 0.0 && scale()->unit.dimension.dimensionless();
  const std::string wrong =
      zero && value.signature()->type == own.type ? "" : mismatch(own, *value.signature());
  if (!wrong.empty())
    throw std::invalid_argument(fmt::format("{} = \"{}\", and value goes where {} is needed: {}",
                                            scale().name(), scale().text(),
                                            value.signature()->text(), wrong));
}

double Waveform::in_own_unit(const Parameter<Quantity>& parameter) const {
  const bool zero = parameter->value == 0.0 && parameter->unit.dimension.dimensionless();
  if (!zero && parameter->unit.dimension != value.signature()->units.front().dimension)
    throw std::invalid_argument(
        fmt::format("{} = \"{}\": needs {}, as {} = \"{}\" has", parameter.name(), parameter.text(),
                    value.signature()->units.front().symbol, scale().name(), scale().text()));
  return parameter->value;
}

}  // namespace trocar
