// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/laparoscope_loads.hpp"
#include "framework/device.hpp"
#include "framework/parameter_set.hpp"

namespace trocar {

/// What rendering may do to the hand on the laparoscope's handle, as parameters.
struct HandleCapParameters {
  explicit HandleCapParameters(ParameterSet* set) : owner(set) {}
  /// Of an effort, for the gate: beyond a cap rendering is scaled down, beyond twice it trips.
  void add(const LaparoscopeLoads::Loads& on, ToolLoads& loads) const RT_SAFE;

  ParameterSet* owner;
  Parameter<double> handle_force_cap{owner,
                                     "handle_force_cap",
                                     {.unit = "N",
                                      .initial = "20 N",
                                      .min = "1 N",
                                      .max = "100 N",
                                      .doc = "of what is rendered; twice it trips",
                                      .live = true}};
  Parameter<double> handle_moment_cap{owner,
                                      "handle_moment_cap",
                                      {.unit = "N m",
                                       .initial = "1 N m",
                                       .min = "0.05 N m",
                                       .max = "5 N m",
                                       .doc = "of what is rendered; twice it trips",
                                       .live = true}};
};

}  // namespace trocar
