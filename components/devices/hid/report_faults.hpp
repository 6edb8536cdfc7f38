// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/report_bytes.hpp"
#include "components/devices/seeded_random.hpp"

namespace trocar::hid {

/// What a tester orders to go wrong on the way of reports.
struct ReportFaultOrders {
  double loss = 0.0;           // share of the reports that never arrive, 0 to 1
  double corruption = 0.0;     // share in which one bit is turned, 0 to 1
  std::uint32_t delay_us = 0;  // longer under way
  bool stuck = false;          // the last one before comes again and again
};

/// A way of reports on which things go wrong as ordered, in the sender's time. Three draws for each
/// report, whatever comes of them, so that an order leaves the others' draws as they are.
class ReportFaults {
 public:
  explicit ReportFaults(std::uint64_t seed) : random_(seed) {}

  ReportFaultOrders orders{};

  void send(const Report& report, std::uint32_t now_us) RT_SAFE;
  /// The next one that has arrived by now, in the order of sending; false when there is none.
  bool arrived(std::uint32_t now_us, Report& report) RT_SAFE;
  void clear() RT_SAFE { count_ = 0; }  // all that is under way

 private:
  struct UnderWay {
    Report report{};
    std::uint32_t due_us = 0;
  };
  SeededRandom random_;
  Report last_{};
  std::array<UnderWay, 64> way_{};  // as many as hidraw keeps
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace trocar::hid
