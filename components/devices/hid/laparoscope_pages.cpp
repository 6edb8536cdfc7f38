// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/laparoscope_pages.hpp"

#include <algorithm>

namespace trocar::hid {

LaparoscopePages laparoscope_pages(const LaparoscopeGeometry& geometry, const DeviceLimits& limits,
                                   const LaparoscopeDriveSettings& drive) {
  LaparoscopePages pages;
  constexpr std::string_view model = "Trocar laparoscope";
  std::copy(model.begin(), model.end(), pages.identity.model.begin());
  pages.geometry = {.tool_length = static_cast<float>(geometry.tool_length),
                    .ring_plane = static_cast<float>(geometry.ring_plane),
                    .ring_radius = static_cast<float>(geometry.ring_radius),
                    .base_radius = static_cast<float>(geometry.base_radius),
                    .platform_radius = static_cast<float>(geometry.platform_radius),
                    .link_length = static_cast<float>(geometry.link_length),
                    .roll = static_cast<std::uint8_t>(geometry.roll)};
  for (std::size_t i = 0; i < axes; ++i) {
    pages.range.lowest[i] = static_cast<float>(limits.lowest.axis[i]);
    pages.range.highest[i] = static_cast<float>(limits.highest.axis[i]);
    pages.limits.peak[i] = static_cast<float>(limits.effort.axis[i]);
    pages.limits.speed[i] = static_cast<float>(limits.speed.axis[i]);
    pages.calibration.unit[i] =
        static_cast<float>(i < 3 ? drive.slider.resolution : drive.ring.resolution);
  }
  return pages;
}

LaparoscopeGeometry geometry_of(const GeometryPage& page) {
  LaparoscopeGeometry geometry;
  geometry.tool_length = static_cast<double>(page.tool_length);
  geometry.ring_plane = static_cast<double>(page.ring_plane);
  geometry.ring_radius = static_cast<double>(page.ring_radius);
  geometry.base_radius = static_cast<double>(page.base_radius);
  geometry.platform_radius = static_cast<double>(page.platform_radius);
  geometry.link_length = static_cast<double>(page.link_length);
  geometry.roll = static_cast<RollModel>(page.roll);
  return geometry;
}

}  // namespace trocar::hid
