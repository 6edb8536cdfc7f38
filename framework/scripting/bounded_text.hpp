// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "framework/realtime/rt_safe.hpp"

namespace trocar::lua {

/// Formats into memory that is there already: what does not fit is cut off.
template <typename... Values>
std::string_view print(std::span<char> to, fmt::format_string<Values...> format,
                       Values&&... values) RT_SAFE {
  const auto end = fmt::format_to_n(to.data(), to.size(), format, std::forward<Values>(values)...);
  return {to.data(), std::min(end.size, to.size())};
}

}  // namespace trocar::lua
