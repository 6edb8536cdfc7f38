// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "components/devices/laparoscope_plant.hpp"

namespace trocar::test {

inline constexpr double tick = 1e-3;  // [s]

/// A perfect device that floats freely.
inline LaparoscopePlantSettings ideal() {
  LaparoscopePlantSettings s;
  s.imperfections = Imperfections::none();
  s.gravity = Eigen::Vector3d::Zero();
  s.hand.mode = HandMode::absent;
  return s;
}

inline void run(LaparoscopePlant& plant, double seconds) {
  const int ticks = static_cast<int>(std::lround(seconds / tick));
  for (int k = 0; k < ticks; ++k) plant.advance(tick, LaparoscopePlant::substeps(tick));
}

inline LaparoscopeRates rates_of(const LaparoscopePlant& plant) {
  return plant.dynamics().model().rates(plant.configuration());
}

inline Vector6d weight_of(const LaparoscopePlant& plant, const Eigen::Vector3d& gravity) {
  return plant.dynamics().gravity().effort(plant.configuration(), rates_of(plant), gravity);
}

}  // namespace trocar::test
