// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace trocar {

/// CRC-32 of ISO 3309 (polynomial 0x04C11DB7, reflected), as zlib, PNG and MCAP
/// use it. Pass the last result to go on where an earlier span ended.
std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t so_far = 0);

}  // namespace trocar
