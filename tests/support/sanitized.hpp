// SPDX-License-Identifier: Apache-2.0
// Under a sanitizer, ten times as slow, what only repeats is done fewer times.
#pragma once

namespace trocar::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

}  // namespace trocar::test
