// SPDX-License-Identifier: Apache-2.0
#include "components/register.hpp"

namespace trocar {

void register_components(Registry&) {}

}  // namespace trocar
