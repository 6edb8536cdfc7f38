// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/device_reader.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>

namespace trocar::hid {
namespace {

constexpr std::int64_t look_again_ns = 100'000'000;
constexpr std::int64_t first_report_ns = 200'000'000;

ReportCheckSettings check_settings(const LaparoscopePages& pages, std::int64_t oldest_ns) {
  ReportCheckSettings settings{.oldest_ns = oldest_ns};
  for (std::size_t i = 0; i < axes; ++i)
    settings.speed[i] = static_cast<double>(pages.limits.speed[i]) /
                        std::abs(static_cast<double>(pages.calibration.unit[i]));
  return settings;
}

/// All that the loop was built on; the firmware's version may differ.
bool same_device(const LaparoscopePages& a, const LaparoscopePages& b) {
  return a.identity.serial == b.identity.serial && a.identity.period_us == b.identity.period_us &&
         a.geometry == b.geometry && a.range == b.range && a.limits == b.limits &&
         a.calibration == b.calibration;
}

}  // namespace

const char* trouble_of(ReportVerdict verdict) RT_SAFE {
  switch (verdict) {
    case ReportVerdict::state:
    case ReportVerdict::page:
      return "";
    case ReportVerdict::too_short:
    case ReportVerdict::too_long:
      return "reports of another length";
    case ReportVerdict::corrupted:
      return "reports corrupted";
    case ReportVerdict::foreign:
    case ReportVerdict::malformed:
      return "reports not of the protocol";
    case ReportVerdict::repeated:
      return "reports repeated";
    case ReportVerdict::reordered:
      return "reports out of order";
    case ReportVerdict::stale:
      return "reports late";
    case ReportVerdict::encoder_jump:
    case ReportVerdict::unhomed_by_jump:
      return "encoder jump";
  }
  return "";
}

const LaparoscopePages& DeviceReader::open() {
  LinkPair pair = source_.open();
  pages_ = read_pages(*pair.in, *pair.out, time_);
  check_.emplace(check_settings(pages_, oldest_ns_));
  connect(std::move(pair));
  const std::int64_t end = time_.now() + first_report_ns;
  while (!snapshot_.any && time_.now() < end) serve(1);
  if (!snapshot_.any)
    throw std::runtime_error(std::string("the device tells its pages and no state: ") +
                             snapshot_.trouble);
  return pages_;
}

void DeviceReader::connect(LinkPair pair) {
  in_ = std::move(pair.in);
  exchange_.outlet.put(std::move(pair.out));
  check_->reset();
  snapshot_.connected = true;
  snapshot_.trouble = "no report yet";
  snapshot_.any = false;
  ++snapshot_.connections;
  publish();
}

bool DeviceReader::serve(int timeout_ms) {
  if (in_ == nullptr) return reopen(timeout_ms);
  std::array<std::uint8_t, report_size + 1> bytes{};  // one more, to see what is too long
  const int size = in_->read(bytes, timeout_ms);
  if (size == 0) return false;
  if (size > 0) {
    take(ReportBytes(bytes.data(), static_cast<std::size_t>(size)), time_.now());
    return true;
  }
  in_.reset();
  snapshot_.connected = snapshot_.any = false;
  snapshot_.trouble = "unplugged";
  publish();
  return true;
}

/// @param timeout_ms 0: looks, where it is time for it, and does not wait
bool DeviceReader::reopen(int timeout_ms) {
  const std::int64_t now = time_.now();
  if (now < try_again_ns_) {
    if (timeout_ms > 0)
      time_.sleep_until(std::min(try_again_ns_, now + std::int64_t{timeout_ms} * 1'000'000));
    return false;
  }
  try_again_ns_ = now + look_again_ns;
  try {
    LinkPair pair = source_.open();
    if (same_device(read_pages(*pair.in, *pair.out, time_), pages_)) {
      connect(std::move(pair));
      return true;
    }
    snapshot_.trouble = "another device is plugged in";
  } catch (const std::exception&) {
    return false;  // not there yet, or not ready
  }
  publish();
  return false;
}

void DeviceReader::take(ReportBytes bytes, std::int64_t now_ns) {
  const ReportVerdict verdict = check_->take(bytes, now_ns);
  ++snapshot_.received;
  if (verdict == ReportVerdict::page) return;
  snapshot_.trouble = trouble_of(verdict);
  snapshot_.jumped = verdict == ReportVerdict::encoder_jump ||
                     verdict == ReportVerdict::unhomed_by_jump ||
                     (snapshot_.jumped && verdict != ReportVerdict::state);
  if (verdict == ReportVerdict::state) {
    snapshot_.any = true;
    snapshot_.state = check_->state();
    snapshot_.device_us = check_->device_time_us();
    snapshot_.arrival_ns = now_ns;
    snapshot_.under_way_ns = check_->age_ns(now_ns);
  }
  if (verdict == ReportVerdict::state || snapshot_.jumped) snapshot_.heard_ns = now_ns;
  snapshot_.lost = static_cast<std::int64_t>(check_->lost());
  snapshot_.repeated = static_cast<std::int64_t>(check_->count(ReportVerdict::repeated));
  snapshot_.refused =
      snapshot_.received - static_cast<std::int64_t>(check_->count(ReportVerdict::state) +
                                                     check_->count(ReportVerdict::page) +
                                                     check_->count(ReportVerdict::repeated));
  publish();
}

}  // namespace trocar::hid
