// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "framework/realtime/rt_safe.hpp"

namespace trocar::cli {

/// How often the calling thread has called operator new so far. A program that links this has
/// operator new and delete replaced by ones that count. What calls malloc itself is not seen.
std::uint64_t heap_allocations() RT_SAFE;

}  // namespace trocar::cli
