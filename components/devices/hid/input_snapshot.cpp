// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/input_snapshot.hpp"

#include <algorithm>

namespace trocar::hid {

void InputSnapshot::begin(const DeviceLayout& layout) RT_SAFE {
  *this = {};
  number_ns.fill(never);
  for (const LayoutOutput& output : layout.outputs)
    std::copy_n(output.rest, output.size(), value.data() + output.first);
}

void InputSnapshot::attach() RT_SAFE {
  attached = true;
  ++connections;
  heard_ns = never;
  number_ns.fill(never);
}

void InputSnapshot::take(const InputLayout& layout, std::span<const std::uint8_t> bytes,
                         std::int64_t now_ns) RT_SAFE {
  if (!layout.decode(bytes, value)) {
    ++ignored;
    return;
  }
  ++reports;
  heard_ns = now_ns;
  for (std::size_t i = 0; i < layout.fields().size(); ++i)
    if (layout.holds(bytes, i)) number_ns[i] = now_ns;
}

bool InputSnapshot::valid(const LayoutOutput& output, std::int64_t now_ns,
                          std::int64_t stale_ns) const RT_SAFE {
  if (output.held == Held::always) return true;
  if (!attached) return false;
  for (std::size_t i = output.first; i < output.first + output.size(); ++i) {
    if (number_ns[i] == never) return false;
    if (output.held == Held::never && now_ns - number_ns[i] > stale_ns) return false;
  }
  return true;
}

}  // namespace trocar::hid
