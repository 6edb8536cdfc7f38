// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "framework/literal.hpp"

namespace trocar {

/// A value as JSON; what JSON has no word for (nan, inf) becomes null.
std::string literal_json(const Literal& literal);

}  // namespace trocar
