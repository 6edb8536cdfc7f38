// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>

namespace trocar {

/// Lets one thread at a time do something, e.g. call a library that has global state. Locks: not
/// for the loop.
class Exclusive {
 public:
  template <typename Work>
  auto run(Work&& work) {
    const std::lock_guard lock(mutex_);
    return work();
  }

 private:
  std::mutex mutex_;
};

}  // namespace trocar
