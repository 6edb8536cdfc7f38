// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): the same numbers from the same seed
/// with every compiler and library. Not for cryptography.
class SeededRandom {
 public:
  explicit SeededRandom(std::uint64_t seed) : state_(seed) {}

  /// Evenly distributed in [low, high).
  double uniform(double low, double high) RT_SAFE {
    return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
  }

  /// Magnitude evenly distributed in [low, high), either sign.
  double signed_uniform(double low, double high) RT_SAFE {
    const double magnitude = uniform(low, high);
    return uniform(-1.0, 1.0) < 0.0 ? -magnitude : magnitude;
  }

 private:
  std::uint64_t next() RT_SAFE {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace trocar
