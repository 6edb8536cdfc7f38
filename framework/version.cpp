// SPDX-License-Identifier: Apache-2.0
#include "framework/version.hpp"

namespace trocar {

std::string version() {
  return std::to_string(TROCAR_VERSION_MAJOR) + "." + std::to_string(TROCAR_VERSION_MINOR) + "." +
         std::to_string(TROCAR_VERSION_PATCH);
}

}  // namespace trocar
