// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"

namespace trocar {

/// Soft tissue that yields slowly under a load (a Kelvin-Voigt element, Fung 1993, ch. 2):
///
///   tau x' = C load - x,   exactly over each step: x <- C load + (x - C load) exp(-dt/tau)    [m]
///
/// for a load that stays over the step. C is the compliance, tau the time constant; when the load
/// goes, so does the depth. A stable law at any step, so that it can run in a slow thread.
class Creep final : public Component {
 public:
  void start() override { *depth = 0.0; }
  void step(const Tick& tick) RT_SAFE override;

  Input<double> load{this, "load", {.unit = "N", .doc = "on the tissue"}};
  Output<double> depth{this, "depth", {.unit = "m", .doc = "by which it has yielded"}};
  Parameter<double> compliance{this,
                               "compliance",
                               {.unit = "m/N",
                                .initial = "0.1 mm/N",
                                .min = "0 mm/N",
                                .max = "100 mm/N",
                                .doc = "C, depth for each newton in the end",
                                .live = true}};
  Parameter<double> time_constant{this,
                                  "time_constant",
                                  {.unit = "s",
                                   .initial = "0.5 s",
                                   .min = "1 ms",
                                   .max = "1000 s",
                                   .doc = "tau, in which 63 % of the way is gone",
                                   .live = true}};
};

}  // namespace trocar
