// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <type_traits>

#include "framework/realtime/latest_slot.hpp"

namespace trocar {

/// The newest value of one thread for any others, wait-free on all sides: a LatestSlot with a type.
template <typename T>
class Latest {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Latest() : slot_(sizeof(T)) {}

  /// By one thread alone.
  void store(const T& value) RT_SAFE {
    slot_.store(++stored_, std::as_bytes(std::span(&value, 1)));
  }
  /// False, and `value` is as it was, before the first one, or when the writer was too fast for
  /// LatestSlot::most_tries times.
  bool load(T& value) const RT_SAFE {
    T copy;
    if (!slot_.load(std::numeric_limits<std::int64_t>::max(),
                    std::as_writable_bytes(std::span(&copy, 1))))
      return false;
    value = copy;
    return true;
  }

 private:
  LatestSlot slot_;
  std::int64_t stored_ = 0;  // the writer's own
};

}  // namespace trocar
