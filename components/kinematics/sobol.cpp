// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/sobol.hpp"

#include <bit>

#include "components/devices/seeded_random.hpp"

namespace trocar {
namespace {

constexpr std::size_t bits = 32;
using Directions = std::array<std::uint32_t, bits>;

struct Polynomial {
  std::size_t degree;
  std::uint32_t coefficients;       // all but the first and the last, which are 1
  std::array<std::uint32_t, 5> m0;  // initial direction numbers, `degree` of them
};

// The lines d = 2 to 8 of new-joe-kuo-6.21201.
constexpr std::array<Polynomial, Sobol::most_dimensions - 1> joe_kuo{{{1, 0, {1}},
                                                                      {2, 1, {1, 3}},
                                                                      {3, 1, {1, 3, 1}},
                                                                      {3, 2, {1, 1, 1}},
                                                                      {4, 1, {1, 1, 3, 3}},
                                                                      {4, 4, {1, 3, 5, 13}},
                                                                      {5, 2, {1, 1, 5, 5, 17}}}};

constexpr Directions directions_of(const Polynomial& p) {
  Directions v{};
  for (std::size_t i = 0; i < bits; ++i) {
    if (i < p.degree) {
      v[i] = p.m0[i] << (bits - 1 - i);
      continue;
    }
    v[i] = v[i - p.degree] ^ (v[i - p.degree] >> p.degree);
    for (std::size_t k = 1; k < p.degree; ++k)
      if ((p.coefficients >> (p.degree - 1 - k) & 1u) != 0) v[i] ^= v[i - k];
  }
  return v;
}

constexpr std::array<Directions, Sobol::most_dimensions> all_directions() {
  std::array<Directions, Sobol::most_dimensions> all{};
  for (std::size_t i = 0; i < bits; ++i) all[0][i] = 1u << (bits - 1 - i);  // van der Corput
  for (std::size_t d = 1; d < all.size(); ++d) all[d] = directions_of(joe_kuo[d - 1]);
  return all;
}

constexpr auto directions = all_directions();

}  // namespace

Sobol::Sobol(std::uint64_t seed) {
  SeededRandom random(seed);
  for (std::uint32_t& one : shift_) one = static_cast<std::uint32_t>(random.uniform(0.0, 0x1p32));
  digits_ = shift_;
}

void Sobol::seek(std::uint64_t index) {
  index_ = index;
  digits_ = shift_;
  const std::uint64_t gray = index ^ (index >> 1);
  for (std::size_t bit = 0; bit < bits; ++bit)
    if ((gray >> bit & 1u) != 0)
      for (std::size_t d = 0; d < most_dimensions; ++d) digits_[d] ^= directions[d][bit];
}

Sobol::Point Sobol::next() {
  Point point;
  const auto changed = static_cast<std::size_t>(std::countr_one(index_++));
  for (std::size_t d = 0; d < most_dimensions; ++d) {
    point[d] = digits_[d] * 0x1p-32;
    if (changed < bits) digits_[d] ^= directions[d][changed];
  }
  return point;
}

}  // namespace trocar
