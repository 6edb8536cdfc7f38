// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/declare_number.hpp"

namespace trocar {

/// What a host expects of a laparoscope before it is there. The device's own pages must agree.
struct HidLaparoscopeParameters {
  explicit HidLaparoscopeParameters(ParameterSet* set) : owner(set) {}

  ParameterSet* owner;
  Parameter<double> report_stale = number("report_stale", "s", "5 ms", "1 ms", "5 ms",
                                          "age beyond which a report is not trusted any more");
  Parameter<double> slider_effort =
      number("slider_effort", "N", "200 N", "1 N", "200 N", "that may be sent to a slider");
  Parameter<double> ring_effort =
      number("ring_effort", "N m", "12 N m", "0.1 N m", "12 N m", "that may be sent to a ring");
  Parameter<double> slider_resolution = number("slider_resolution", "m", "2 um", "0.01 um",
                                               "100 um", "of the encoders, at most: for damping");
  Parameter<double> ring_resolution =
      number("ring_resolution", "rad", "0.0001022654 rad", "0.000001 rad", "0.01 rad",
             "of the encoders, at most: for damping");
  Parameter<Vector3> unhomed_position{
      owner,
      "unhomed_position",
      {.unit = "m", .initial = "0, 0, 85 mm", .doc = "of E, told until the device is homed"}};

 private:
  Parameter<double> number(const char* name, const char* unit, const char* initial, const char* min,
                           const char* max, const char* doc) {
    return declare_number(owner, name, {unit, initial, min, max, doc});
  }
};

}  // namespace trocar
