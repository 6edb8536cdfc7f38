// SPDX-License-Identifier: Apache-2.0
#include "components/control/gain_calibration.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace trocar {

void GainCalibration::configure(const Setup&) {
  for (int i = 0; i < 6; ++i) {
    const double g = (*gain)[i];
    if (!(g >= 0.5 && g <= 2.0))
      throw std::invalid_argument(
          fmt::format("gain of axis {} = {:g}: needs 0.5 to 2 for each of the six axes, e.g. "
                      "{{0.97, 0.97, 0.97, 0.97, 0.97, 0.97}}",
                      i + 1, g));
    inverse_[i] = 1.0 / g;
  }
  effort.quality.delay = wanted.delay();
}

void GainCalibration::step(const Tick&) RT_SAFE {
  effort->head<6>() = inverse_.cwiseProduct(wanted->head<6>());
}

}  // namespace trocar
