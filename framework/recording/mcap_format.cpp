// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/mcap_format.hpp"

namespace trocar::mcap {

// Out of line: inlined with a constant size, GCC 12 warns of an overflow that cannot be.
void Bytes::raw(const void* data, std::size_t size) {
  const auto* first = static_cast<const std::byte*>(data);
  bytes_.insert(bytes_.end(), first, first + size);
}

}  // namespace trocar::mcap
