// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>

#include "components/devices/hid/report_bytes.hpp"

namespace trocar::hid {

/// A way of whole reports to and from a device. To be used by one thread.
class Link {
 public:
  static constexpr int gone = -1;

  virtual ~Link() = default;
  /// Waits for the next report.
  /// @param into longer than a report, or one that is too long looks right
  /// @return its number of bytes, 0 when none came in time, or gone, for good
  virtual int read(std::span<std::uint8_t> into, int timeout_ms) = 0;
  /// @return false when the device is gone, for good
  virtual bool write(ReportBytes report) = 0;
};

/// Two ends on the same device, for a thread that reads and one that writes.
struct LinkPair {
  std::unique_ptr<Link> in, out;
};

/// Where the driver gets its links from, at the start and after each loss.
class LinkSource {
 public:
  virtual ~LinkSource() = default;
  /// @throw std::runtime_error that says what was looked for, what there is, and the cure
  virtual LinkPair open() = 0;
};

}  // namespace trocar::hid
