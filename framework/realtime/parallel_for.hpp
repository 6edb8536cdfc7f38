// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace trocar {

struct ParallelOptions {
  unsigned threads = 0;  // the calling one is among them; 0: one for each processor
  /// Called on the calling thread between its own pieces, with how many are done of how many.
  std::function<void(std::size_t done, std::size_t count)> progress = {};
};

/// Calls work(0) to work(count - 1), each once, and waits for all. Each thread takes the next piece
/// that nobody has, so which thread does which, and in what order, is left open: work(i) writes to
/// a place of its own, and whoever sums the places up does it in their order. Then the result is
/// the same to the last bit for any number of threads.
///
/// When one throws, the pieces that nobody has begun are left out. Rethrows the first by index of
/// what was thrown.
void parallel_for(std::size_t count, const ParallelOptions& options,
                  const std::function<void(std::size_t index)>& work);

}  // namespace trocar
