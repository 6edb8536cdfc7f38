// SPDX-License-Identifier: Apache-2.0
#include "components/requirement.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace trocar {

void require(bool holds, std::string_view what, double value, std::string_view allowed) {
  if (!holds) throw std::invalid_argument(fmt::format("{} = {:.6g}: {}", what, value, allowed));
}

}  // namespace trocar
