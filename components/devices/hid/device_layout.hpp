// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/devices/hid/attached_devices.hpp"
#include "components/devices/hid/input_layout.hpp"
#include "framework/component_definition.hpp"

namespace trocar::hid {

/// How many numbers a layout may have: what the reader and the loop exchange has a fixed size.
constexpr std::size_t most_numbers = 64;

/// How long a value is taken for the present one when no report with it comes.
enum class Held {
  never,     // it is at rest once the reports are stale: a velocity, a deflection
  attached,  // until the device is gone: what it sends on a change alone
  always     // a position
};

/// One thing of a device, out of one number of its reports, or of three.
struct LayoutOutput {
  enum class Kind { flag, number, vector };
  std::string name;
  std::string unit{};   // as it was written; values are in SI
  std::string frame{};  // of a vector
  std::string doc{};
  Kind kind = Kind::number;
  std::size_t first = 0;  // of its numbers among the layout's fields
  Held held = Held::never;
  double rest[3] = {};  // [SI]

  std::size_t size() const { return kind == Kind::vector ? 3 : 1; }
};

/// A kind of HID device, as a layout in Lua describes it.
struct DeviceLayout {
  DeviceSelection device{};  // vendor and products
  std::vector<LayoutOutput> outputs{};
  InputLayout fields{{}};  // in the outputs' order
};

/// Reads what a layout's table says. docs/devices.md has its entries.
/// @return nothing, and all mistakes, where it is wrong
std::optional<DeviceLayout> read_device_layout(const Literal& value,
                                               std::vector<DefinitionMistake>& mistakes);

}  // namespace trocar::hid
