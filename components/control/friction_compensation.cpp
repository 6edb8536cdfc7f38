// SPDX-License-Identifier: Apache-2.0
#include "components/control/friction_compensation.hpp"

namespace trocar {

void FrictionCompensation::configure(const Setup&) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    dry_[i] = *share * slider_dry->eigen()[k];
    dry_[i + 3] = *share * ring_dry->eigen()[k];
    viscous_[i] = *share * slider_viscous->eigen()[k];
    viscous_[i + 3] = *share * ring_viscous->eigen()[k];
    bristles_[i].length = *slider_bristle;
    bristles_[i + 3].length = *ring_bristle;
  }
  effort.quality.delay = position.delay();
}

void FrictionCompensation::step(const Tick&) RT_SAFE {
  for (std::size_t i = 0; i < 6; ++i) {
    const int axis = static_cast<int>(i);
    if (!started_) bristles_[i].reset((*position)[axis]);
    (*effort)[axis] =
        dry_[i] * bristles_[i].drag((*position)[axis]) + viscous_[i] * (*velocity)[axis];
  }
  started_ = true;
}

}  // namespace trocar
