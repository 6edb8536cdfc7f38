// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trocar {

std::string_view trim(std::string_view text);
std::vector<std::string_view> split(std::string_view text, char separator);
std::string join(const std::vector<std::string>& parts, std::string_view separator);

/// "VirtualWall" becomes "virtual_wall".
std::string snake_case(std::string_view camel_case);

/// Letters, digits and underscores, starting with a letter: what a component or signal is called.
bool is_name(std::string_view text);

/// The candidate that differs from `text` by the fewest edits (Levenshtein, transpositions count
/// one), or "" when none is near enough to be what was meant.
std::string nearest(std::string_view text, const std::vector<std::string>& candidates);

/// ", did you mean "stiffness"?" or, where nothing is near, ", known are a, b, c".
std::string suggestion(std::string_view text, const std::vector<std::string>& candidates);

}  // namespace trocar
