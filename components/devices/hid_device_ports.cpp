// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid_device_ports.hpp"

namespace trocar {

void HidDevicePorts::update(const hid::DeviceSnapshot& snapshot, std::int64_t now_ns) RT_SAFE {
  *reports_lost = snapshot.lost;
  *reports_repeated = snapshot.repeated;
  *reports_refused = snapshot.refused;
  *connections = snapshot.connections;
  if (!snapshot.any) return;
  const std::int64_t age_ns = snapshot.under_way_ns + now_ns - snapshot.arrival_ns;
  *report_age = static_cast<double>(age_ns) * 1e-9;
  device_state->index = static_cast<std::int64_t>(snapshot.state.state);
  device_fault->index = static_cast<std::int64_t>(snapshot.state.fault);
  *dead_man = snapshot.state.dead_man;
  for (std::size_t i = 0; i < hid::axes; ++i)
    temperature->axis[i] = snapshot.state.temperature[i] - 1.0 * hid::temperature_zero;
}

void HidDevicePorts::update(const hid::WrittenCommand& written,
                            const hid::DeviceSnapshot& snapshot) RT_SAFE {
  const auto place = [this](std::uint16_t sequence) RT_SAFE -> std::int64_t& {
    return begun_ns_[sequence & (begun_ns_.size() - 1)];
  };
  if (written.number != noted_) {
    noted_ = written.number;
    place(written.sequence) = written.begun_ns;
    *write_time = static_cast<double>(written.write_ns) * 1e-9;
  }
  std::int64_t& begun_ns = place(snapshot.state.last_command);
  if (!snapshot.any || begun_ns == 0) return;
  *round_trip = static_cast<double>(snapshot.arrival_ns - begun_ns) * 1e-9;
  begun_ns = 0;  // the first report that confirms it counts
}

const char* fault_name(hid::DeviceFault fault) RT_SAFE {
  switch (fault) {
    case hid::DeviceFault::none:
      return nullptr;
    case hid::DeviceFault::watchdog:
      return "watchdog of the device";
    case hid::DeviceFault::encoder_jump:
      return "encoder jump in the device";
    case hid::DeviceFault::temperature:
      return "temperature of a motor";
    case hid::DeviceFault::speed:
      return "speed of an axis, by the device";
    case hid::DeviceFault::homing:
      return "homing failed";
  }
  return "unknown";
}

}  // namespace trocar
