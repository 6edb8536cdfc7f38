// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/parameter_set.hpp"

namespace trocar {

/// Of a number with a unit, written as a script would.
struct NumberOptions {
  std::string_view unit, initial, min, max, doc;
};

/// The shortest way to declare many numbers of one component.
inline Parameter<double> declare_number(ParameterSet* owner, std::string_view name,
                                        const NumberOptions& o) {
  return {owner,
          name,
          {.unit = o.unit, .initial = o.initial, .min = o.min, .max = o.max, .doc = o.doc}};
}

inline Parameter<bool> declare_switch(ParameterSet* owner, std::string_view name,
                                      std::string_view doc) {
  return {owner, name, {.initial = "true", .doc = doc}};
}

}  // namespace trocar
