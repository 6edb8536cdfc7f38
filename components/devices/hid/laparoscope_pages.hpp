// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/page_report.hpp"
#include "components/devices/laparoscope_drive.hpp"
#include "components/kinematics/laparoscope_geometry.hpp"
#include "framework/device.hpp"

namespace trocar::hid {

/// All that a laparoscope tells of itself.
struct LaparoscopePages {
  IdentityPage identity;
  GeometryPage geometry;
  RangePage range;
  LimitsPage limits;
  CalibrationPage calibration;
};

/// Peak efforts and speeds of `limits`, one encoder count of `drive`, zero at position 0.
LaparoscopePages laparoscope_pages(const LaparoscopeGeometry& geometry, const DeviceLimits& limits,
                                   const LaparoscopeDriveSettings& drive);

/// The geometry that a page tells, in double.
LaparoscopeGeometry geometry_of(const GeometryPage& page);

}  // namespace trocar::hid
