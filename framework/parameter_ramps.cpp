// SPDX-License-Identifier: Apache-2.0
#include "framework/parameter_ramps.hpp"

#include <algorithm>

namespace trocar {

bool ParameterRamps::begin(ParameterBase* parameter, const std::array<double, max_axes>& target,
                           std::int64_t ticks) RT_SAFE {
  std::size_t at = 0;
  while (at < active_ && ramps_[at].parameter != parameter) ++at;
  if (at == capacity) return false;
  Ramp& ramp = ramps_[at];
  ramp = {parameter, {}, target, 0, std::max<std::int64_t>(1, ticks)};
  const std::span<double> numbers = parameter->numbers();
  std::copy(numbers.begin(), numbers.end(), ramp.start.begin());
  active_ = std::max(active_, at + 1);
  return true;
}

void ParameterRamps::advance() RT_SAFE {
  for (std::size_t r = 0; r < active_;) {
    Ramp& ramp = ramps_[r];
    ++ramp.done;
    const double share = static_cast<double>(ramp.done) / static_cast<double>(ramp.ticks);
    const std::span<double> numbers = ramp.parameter->numbers();
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = ramp.done == ramp.ticks
                       ? ramp.target[i]
                       : ramp.start[i] + share * (ramp.target[i] - ramp.start[i]);
    if (ramp.done == ramp.ticks)
      ramp = ramps_[--active_];
    else
      ++r;
  }
}

}  // namespace trocar
