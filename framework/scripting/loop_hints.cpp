// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/loop_hints.hpp"

namespace trocar::lua {
namespace {

struct Hint {
  std::string_view first;
  std::string_view second;  // both must be there
  std::string_view cure;
};

// The first that fits wins.
constexpr Hint hints[] = {
    {"arithmetic on a string", "",
     "; inside the loop numbers are SI: declare a parameter with a unit, and use it"},
    {"a 'string'", "",
     "; inside the loop numbers are SI: declare a parameter with a unit, and use it"},
    {"unexpected symbol near '}'", "", "; an end may be missing before it"},
    {"arithmetic on a nil", "",
     "; give it a value first, and let every path of a function return one"},
    {"arithmetic on a table", "", "; vec(x, y, z) makes a vector that +, -, * and / take"},
    {"arithmetic on a function", "", "; call it, with ()"},
    {"arithmetic on a boolean", "", "; write: condition and number or 0"},
    {"compare nil", "", "; give it a value first"},
    {"compare number with nil", "", "; give it a value first"},
    {"compare", "string", "; inside the loop numbers are SI: compare with a parameter"},
    {"compare", "table", "; compare fields, or v:norm()"},
    {"compare", "", "; compare numbers with numbers"},
    {"index a number", "", "; it is a number: it has no fields"},
    {"index a nil", "", "; give it a value first: a table of state = { … }, or a local"},
    {"call a nil", "method", "; a vector has set, add, sub, scale, add_scaled, dot, cross, norm"},
    {"call a nil", "", "; there is no such function"},
    {"call a number", "", "; * multiplies, and a comma may be missing"},
    {"call a table", "", "; a comma may be missing"},
    {"concatenate", "", "; texts are joined with .. : numbers are outputs"},
    {"stack overflow", "", "; let it call itself less deeply"},
    {"not enough memory", "", "; keep what it makes within bounds, or raise \"memory\""},
    {"number has no integer", "", "; use math.floor"},
    {"perform 'n//0'", "", "; test for 0 first"},
    {"perform 'n%%0'", "", "; test for 0 first"},
    {"bad argument", "number expected, got nil", "; give it a value first"},
    {"bad argument", "number expected", "; it needs a number"},
    {"'for'", "must be a number", "; it needs numbers: for i = 1, 10 do"},
    {"near", "'='", "; a comparison is =="},
    {"near '!'", "", "; not equal is ~="},
    {"'end' expected", "", "; an end is missing"},
    {"'}' expected", "", "; a comma or a } is missing"},
    {"near", "", "; look at this line and at the one before"},
};

bool has(std::string_view message, std::string_view part) RT_SAFE {
  return message.find(part) != std::string_view::npos;
}

}  // namespace

std::string_view hint_for(std::string_view message) RT_SAFE {
  for (const Hint& hint : hints)
    if (has(message, hint.first) && has(message, hint.second)) return hint.cure;
  return "";
}

}  // namespace trocar::lua
