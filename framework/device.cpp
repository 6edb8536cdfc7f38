// SPDX-License-Identifier: Apache-2.0
#include "framework/device.hpp"

#include <fmt/format.h>

namespace trocar {

std::vector<std::string> DeviceLimits::missing() const {
  std::vector<std::string> names;
  const std::pair<const char*, const Joints*> by_axis[] = {{"effort", &effort},
                                                           {"rise", &rise},
                                                           {"speed", &speed},
                                                           {"margin", &margin},
                                                           {"jump", &jump},
                                                           {"damping", &damping},
                                                           {"damping_cap", &damping_cap},
                                                           {"hold_tolerance", &hold_tolerance}};
  if (axes < 1 || axes > max_axes) return {"axes"};
  for (const auto& [name, values] : by_axis)
    for (int i = 0; i < axes; ++i)
      if (!((*values)[i] >= 0.0)) names.push_back(fmt::format("{} of axis {}", name, i + 1));
  for (int i = 0; i < axes; ++i)
    if (!(lowest[i] < highest[i])) names.push_back(fmt::format("range of axis {}", i + 1));
  if (!(handle_speed > 0.0)) names.push_back("handle_speed");
  return names;
}

}  // namespace trocar
