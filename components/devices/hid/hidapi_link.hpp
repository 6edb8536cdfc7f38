// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/attached_devices.hpp"
#include "components/devices/hid/link.hpp"

struct hid_device_;

namespace trocar::hid {

/// Reports of a real device, by hidapi over hidraw.
class HidapiLink final : public Link {
 public:
  /// @throw std::runtime_error with the path and the reason
  explicit HidapiLink(const std::string& path);
  ~HidapiLink() override;
  HidapiLink(const HidapiLink&) = delete;
  HidapiLink& operator=(const HidapiLink&) = delete;

  int read(std::span<std::uint8_t> into, int timeout_ms) override;
  bool write(ReportBytes report) override;

 private:
  hid_device_* device_;
};

/// The device that is meant, wherever it is attached now. While a source has it open, no other
/// source gets it, in this process or another one.
class HidapiSource final : public LinkSource {
 public:
  explicit HidapiSource(DeviceSelection selection) : selection_(std::move(selection)) {}
  ~HidapiSource() override;
  HidapiSource(const HidapiSource&) = delete;
  HidapiSource& operator=(const HidapiSource&) = delete;

  LinkPair open() override;

 private:
  void claim(const AttachedDevice& device);

  DeviceSelection selection_;
  int claim_ = -1;  // an open file, locked
};

/// Why a device's file could not be opened, with the cure. @param error of errno
std::string opening_failed(const AttachedDevice& device, int error);

}  // namespace trocar::hid
