// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Core>

#include "framework/realtime/rt_safe.hpp"

// C++20 and Eigen come with the package's targets.
double reach(const Eigen::Vector3d& tip) RT_SAFE;
double reach(const Eigen::Vector3d& tip) RT_SAFE {
  return tip.norm();
}

int main() {
  return reach({0.0, 3.0, 4.0}) == 5.0 ? 0 : 1;
}
