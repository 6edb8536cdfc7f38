// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "cli/device_port.hpp"
#include "cli/effort_end.hpp"
#include "components/devices/hid/emulated_laparoscope.hpp"
#include "components/devices/hid/report_faults.hpp"

namespace trocar::cli {

/// An emulated device at its port, and what a tester orders to go wrong.
class Emulator {
 public:
  Emulator(const hid::EmulatedLaparoscopeSettings& settings, DevicePort& port)
      : device_(settings), port_(port) {}

  /// One cycle of the firmware.
  void cycle();
  /// Carries out a line of text: "loss 20%", "unplug", …
  /// @return what to tell the tester; "" when there is nothing to say
  /// @throw std::invalid_argument with what is possible
  std::string obey(std::string_view line);
  /// Whether the tester wants to end it.
  bool over() const { return over_; }
  const hid::EmulatedLaparoscope& device() const { return device_; }

  /// The orders, a line each.
  static const char* orders();

 private:
  void receive(hid::ReportBytes bytes);
  void plug(bool plugged);
  std::string state() const;

  hid::EmulatedLaparoscope device_;
  hid::ReportFaults faults_{1};
  EffortEnd effort_end_;
  DevicePort& port_;
  bool plugged_ = true;
  bool deaf_ = false;
  bool over_ = false;
};

}  // namespace trocar::cli
