// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/parameter_set.hpp"

namespace trocar {

/// What a newcomer sets; the group Laparoscope offers the same.
struct LaparoscopeUseParameters {
  explicit LaparoscopeUseParameters(ParameterSet* set) : owner(set) {}

  ParameterSet* owner;
  Parameter<Choice> hand{
      owner,
      "hand",
      {.initial = "none",
       .doc = "grasps the tool at E: nobody, one that holds loosely or firmly, one that pushes",
       .choices = {"none", "relaxed", "firm", "push"}}};
  Parameter<Choice> start{owner,
                          "start",
                          {.initial = "engaged",
                           .doc = "engaged: held and at rest; cold: on its brake until held",
                           .choices = {"engaged", "cold"}}};
  Parameter<bool> ideal{
      owner,
      "ideal",
      {.initial = "false", .doc = "no friction, no errors, no quantisation: the model itself"}};
};

}  // namespace trocar
