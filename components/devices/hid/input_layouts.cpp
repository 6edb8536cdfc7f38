// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/input_layouts.hpp"

#include <iterator>
#include <utility>

namespace trocar::hid {
namespace {

constexpr double full_deflection = 350.0;  // logical maximum in the SpaceNavigator's descriptor

InputField axis(const char* name, int report, int byte) {
  return {.name = name,
          .report = report,
          .bit = 8 * byte,
          .bits = 16,
          .is_signed = true,
          .scale = 1.0 / full_deflection,
          .unit = ""};
}

InputField button(const char* name, int report, int bit) {
  return {.name = name, .report = report, .bit = bit, .bits = 1, .unit = ""};
}

InputField stick(const char* name, int byte) {
  return {.name = name,
          .report = 1,
          .bit = 8 * byte,
          .bits = 8,
          .centre = 128.0,
          .scale = 1.0 / 128.0,
          .unit = ""};
}

InputField trigger(const char* name, int byte) {
  return {.name = name, .report = 1, .bit = 8 * byte, .bits = 8, .scale = 1.0 / 255.0, .unit = ""};
}

}  // namespace

InputLayout space_navigator() {
  return InputLayout({axis("x", 1, 1), axis("y", 1, 3), axis("z", 1, 5), axis("rx", 2, 1),
                      axis("ry", 2, 3), axis("rz", 2, 5), button("left", 3, 8),
                      button("right", 3, 9)});
}

InputLayout space_mouse_wireless() {
  return InputLayout({axis("x", 1, 1), axis("y", 1, 3), axis("z", 1, 5), axis("rx", 1, 7),
                      axis("ry", 1, 9), axis("rz", 1, 11), button("left", 3, 8),
                      button("right", 3, 9)});
}

InputLayout dualshock4() {
  std::vector<InputField> fields{stick("left_x", 1), stick("left_y", 2), stick("right_x", 3),
                                 stick("right_y", 4)};
  fields.push_back({.name = "hat", .report = 1, .bit = 40, .bits = 4, .unit = ""});
  const char* const buttons[] = {"square", "cross", "circle",  "triangle", "l1", "r1", "l2",
                                 "r2",     "share", "options", "l3",       "r3", "ps", "touchpad"};
  for (int i = 0; i < static_cast<int>(std::size(buttons)); ++i)
    fields.push_back(button(buttons[i], 1, 44 + i));
  fields.push_back(trigger("l2_pull", 8));
  fields.push_back(trigger("r2_pull", 9));
  return InputLayout(std::move(fields));
}

}  // namespace trocar::hid
