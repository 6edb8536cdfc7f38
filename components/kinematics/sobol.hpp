// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace trocar {

/// Points that fill the unit cube more evenly than random ones do: the Sobol sequence in the order
/// of Gray's code (Antonov and Saleev 1979), with the direction numbers new-joe-kuo-6.21201
/// (Joe and Kuo, SIAM J. Sci. Comput. 30(5), 2008).
///
///   x_0 = s,   x_{i+1} = x_i xor v_{c(i)},   c(i): the lowest zero bit of i
///
/// s is a digital shift that is drawn from a seed. It keeps the evenness and makes each single
/// point uniform, so that means over points are unbiased, and the spread of the means under several
/// independent shifts is their standard error (L'Ecuyer and Lemieux 2002). A sum over the first 2^k
/// points is the one to use.
class Sobol {
 public:
  static constexpr std::size_t most_dimensions = 8;
  static constexpr std::uint64_t most_points = std::uint64_t{1} << 32;
  using Point = std::array<double, most_dimensions>;

  /// The sequence as published, beginning with the origin.
  Sobol() = default;
  /// The same under the shift that belongs to `seed`.
  explicit Sobol(std::uint64_t seed);

  /// The next call of next() gives point `index`, counted from 0. @param index < most_points
  void seek(std::uint64_t index);
  /// Coordinates in [0, 1); use as many as are needed.
  Point next();

 private:
  std::array<std::uint32_t, most_dimensions> shift_{};
  std::array<std::uint32_t, most_dimensions> digits_{};
  std::uint64_t index_ = 0;
};

}  // namespace trocar
