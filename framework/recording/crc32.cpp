// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/crc32.hpp"

#include <zlib.h>

namespace trocar {

std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t so_far) {
  return static_cast<std::uint32_t>(
      ::crc32_z(so_far, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace trocar
