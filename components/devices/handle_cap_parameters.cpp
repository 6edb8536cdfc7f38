// SPDX-License-Identifier: Apache-2.0
#include "components/devices/handle_cap_parameters.hpp"

#include "components/devices/laparoscope_device_limits.hpp"

namespace trocar {
namespace {

constexpr double calm_force = 1.0;   // [N] at the handle, to engage
constexpr double calm_moment = 0.1;  // [N m]

}  // namespace

void HandleCapParameters::add(const LaparoscopeLoads::Loads& on, ToolLoads& loads) const RT_SAFE {
  const double force_cap = *handle_force_cap;
  const double moment_cap = *handle_moment_cap;
  loads.add({"handle force", on.handle_force, force_cap, 2.0 * force_cap, calm_force});
  loads.add({"handle moment", on.handle_moment, moment_cap, 2.0 * moment_cap, calm_moment});
  loads.add({.what = "delta stage", .value = on.delta, .cap = laparoscope_stage_force});
  loads.add({.what = "gimbal stage", .value = on.gimbal, .cap = laparoscope_stage_force});
}

}  // namespace trocar
