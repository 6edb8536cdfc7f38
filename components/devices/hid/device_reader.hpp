// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/devices/hid/device_exchange.hpp"
#include "components/devices/hid/page_reader.hpp"

namespace trocar::hid {

/// What the reading thread of a driver does: takes reports, judges them, tells the loop, and finds
/// the device again when it was gone.
class DeviceReader {
 public:
  DeviceReader(LinkSource& source, TimeSource& time, DeviceExchange& exchange,
               std::int64_t oldest_ns)
      : source_(source), time_(time), exchange_(exchange), oldest_ns_(oldest_ns) {}

  /// Finds the device, reads its pages and its first state.
  /// @throw std::runtime_error as LinkSource and read_pages, or when no state comes
  const LaparoscopePages& open();
  /// Takes one report, or looks for a device that is gone. @return false when there was nothing
  bool serve(int timeout_ms);

 private:
  void connect(LinkPair pair);
  bool reopen(int timeout_ms);
  void take(ReportBytes bytes, std::int64_t now_ns);
  void publish() {
    exchange_.snapshot.store(snapshot_);
    exchange_.arrival.ring();
  }

  LinkSource& source_;
  TimeSource& time_;
  DeviceExchange& exchange_;
  std::int64_t oldest_ns_;
  LaparoscopePages pages_;
  std::optional<ReportCheck> check_;
  std::unique_ptr<Link> in_;
  DeviceSnapshot snapshot_;
  std::int64_t try_again_ns_ = 0;
};

/// "reports corrupted", …; "" for those that are taken.
const char* trouble_of(ReportVerdict verdict) RT_SAFE;

}  // namespace trocar::hid
