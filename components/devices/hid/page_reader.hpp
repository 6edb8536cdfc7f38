// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/laparoscope_pages.hpp"
#include "components/devices/hid/link.hpp"
#include "framework/time_source.hpp"

namespace trocar::hid {

/// Asks a device for its pages, each up to five times, 100 ms apart. State reports meanwhile are
/// passed over.
/// @throw std::runtime_error when it does not answer, or with what no device can mean
LaparoscopePages read_pages(Link& in, Link& out, TimeSource& time);

/// What a host expects of a device, whose graph was checked before the device was there.
struct ExpectedLaparoscope {
  LaparoscopeGeometry geometry{};
  DeviceLimits limits{};         // effort and range
  PerAxis<double> resolution{};  // of the encoders, at most [m, rad]
  std::int64_t oldest_report_ns = 0;
};

/// @throw std::invalid_argument with all that differs: names, both values and what to set
void require_agreement(const LaparoscopePages& pages, const ExpectedLaparoscope& expected);

}  // namespace trocar::hid
