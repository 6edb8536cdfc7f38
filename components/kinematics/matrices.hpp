// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "framework/abi.hpp"

namespace trocar {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Matrix36d = Eigen::Matrix<double, 3, 6>;
using Matrix23d = Eigen::Matrix<double, 2, 3>;  // one planar vector per column

}  // namespace trocar
