// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace trocar::lua {

/// The line of a file in Lua that says `c = …`, behind `b = …`, behind `a = …`, for the path a, b,
/// c; that of the last name that was found where one is missing, and 1 where none is. Lua keeps no
/// lines of a table's entries, so this is the best guess by the text.
int line_of_entry(std::string_view text, std::span<const std::string> path);

}  // namespace trocar::lua
