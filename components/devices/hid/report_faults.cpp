// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/report_faults.hpp"

#include "components/devices/hid/report_envelope.hpp"

namespace trocar::hid {

void ReportFaults::send(const Report& report, std::uint32_t now_us) RT_SAFE {
  const bool lost = random_.uniform(0.0, 1.0) < orders.loss;
  const bool corrupted = random_.uniform(0.0, 1.0) < orders.corruption;
  const auto bit = static_cast<unsigned>(random_.uniform(0.0, 8.0 * report_size));
  if (!orders.stuck) last_ = report;
  if (lost || count_ == way_.size()) return;
  UnderWay& sent = way_[(first_ + count_++) & (way_.size() - 1)];
  sent = {last_, now_us + orders.delay_us};
  if (corrupted)
    sent.report[bit / 8] = static_cast<std::uint8_t>(sent.report[bit / 8] ^ 1u << (bit & 7u));
}

bool ReportFaults::arrived(std::uint32_t now_us, Report& report) RT_SAFE {
  if (count_ == 0 || serial_difference(way_[first_].due_us, now_us) > 0) return false;
  report = way_[first_].report;
  first_ = (first_ + 1) & (way_.size() - 1);
  --count_;
  return true;
}

}  // namespace trocar::hid
