// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "components/devices/hid/report_bytes.hpp"

namespace trocar::cli {

/// Where an emulated device is plugged in, seen from the device. Nothing waits.
class DevicePort {
 public:
  virtual ~DevicePort() = default;
  /// What the host sent. @return its number of bytes, 0: nothing now
  virtual std::size_t receive(std::span<std::uint8_t> into) = 0;
  /// What the host does not take is lost.
  virtual void send(const hid::Report& report) = 0;
  virtual void plug() = 0;
  virtual void unplug() = 0;
};

/// A socket of SOCK_SEQPACKET in the file system; one host at a time.
/// @throw std::runtime_error with the path and the reason
std::unique_ptr<DevicePort> socket_port(const std::string& path);

/// The device's side of a USB gadget's HID function, such as /dev/hidg0.
///  controller the gadget's file UDC, which plugs it. Without, plugging is the business of who
///   made the gadget: plug() and unplug() throw
/// @throw std::runtime_error with the path and the reason
std::unique_ptr<DevicePort> gadget_port(const std::string& path,
                                        const std::string& controller = "");

struct UhidIdentity {
  std::uint16_t vendor = 0x1209, product = 0x0001;
  std::string serial;
};

/// A device of Linux' uhid, by /dev/uhid.
/// @throw std::runtime_error with the path and the reason
std::unique_ptr<DevicePort> uhid_port(const std::string& path, const UhidIdentity& identity);

}  // namespace trocar::cli
