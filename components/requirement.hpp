// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace trocar {

/// Of the settings of an algorithm, e.g. require(length > 0.0, "geometry: tool_length", length,
/// "needs a length above 0 m, e.g. 0.150").
/// @throw std::invalid_argument "WHAT = VALUE: ALLOWED" unless it holds.
void require(bool holds, std::string_view what, double value, std::string_view allowed);

}  // namespace trocar
