// SPDX-License-Identifier: Apache-2.0
#include "components/control/delay.hpp"

#include <algorithm>

#include "components/signal.hpp"

namespace trocar {

/// A bare zero may be of any unit: it does not say what the loop carries.
std::optional<Signature> Delay::natural_signature() const {
  const auto* number = initial->as<double>();
  if (number != nullptr && *number == 0.0) return std::nullopt;
  return natural_signature_of(*initial);
}

void Delay::configure(const Setup& setup) {
  initial_ = read_numbers(*initial, *value.signature(), "initial");
  past_.clear();
  for (std::int64_t i = 0; i < *ticks; ++i)
    past_.insert(past_.end(), initial_.begin(), initial_.end());
  value.quality.delay = input.delay() + static_cast<double>(*ticks) * setup.period;
  value.quality.resolution.clear();
  for (std::size_t i = 0; i < initial_.size(); ++i)
    value.quality.resolution.push_back(input.resolution(i));
}

void Delay::start() {
  oldest_ = 0;
  started_ = false;
  recall();
}

void Delay::step(const Tick&) RT_SAFE {
  const bool this_tick = input.sources().front().this_tick;
  if (!this_tick && started_) store();
  recall();
  if (this_tick) store();
  started_ = true;
}

void Delay::store() RT_SAFE {
  for (std::size_t i = 0; i < initial_.size(); ++i) past_[oldest_ + i] = input.values()[i];
  oldest_ = (oldest_ + initial_.size()) % past_.size();
}

void Delay::recall() RT_SAFE {
  for (std::size_t i = 0; i < initial_.size(); ++i) value.values()[i] = past_[oldest_ + i];
}

}  // namespace trocar
