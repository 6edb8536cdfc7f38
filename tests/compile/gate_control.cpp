// SPDX-License-Identifier: Apache-2.0
// Must compile: what everybody may do with a device and a command.
#include "framework/gate.hpp"

struct Reader : trocar::Component {
  double look(trocar::Device& device, const trocar::GatedEffort& command) {
    return (*device.position())[0] + command.effort()[0];
  }
  void step(const trocar::Tick&) RT_SAFE override {}
};
