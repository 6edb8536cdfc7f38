// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_limit_parameters.hpp"
#include "components/kinematics/laparoscope_parameters.hpp"
#include "framework/component.hpp"

namespace trocar {

/// Where the laparoscope's tool reaches, for experiments: sampled when it is configured, the same
/// in every tick. `trocar workspace` shows more of it; workspace.hpp says how it is sampled.
class LaparoscopeWorkspace final : public Component {
 public:
  /// @throw std::invalid_argument for a geometry or limits that cannot be.
  void configure(const Setup& setup) override;
  void step(const Tick& tick) RT_SAFE override;

  Output<double> volume{
      this, "volume", {.unit = "m^3", .doc = "that the tip reaches, in any orientation"}};
  Output<double> standard_error{this, "standard_error", {.unit = "m^3", .doc = "of the volume"}};
  Output<Vector3> lowest{
      this, "lowest", {.unit = "m", .frame = "device", .doc = "coordinates of the tip"}};
  Output<Vector3> highest{
      this, "highest", {.unit = "m", .frame = "device", .doc = "coordinates of the tip"}};
  Output<double> yaw{this, "yaw", {.unit = "rad", .doc = "reached to both sides"}};
  Output<double> pitch{this, "pitch", {.unit = "rad", .doc = "reached to both sides"}};
  Output<double> insertion{
      this,
      "insertion",
      {.unit = "m", .doc = "range of the upright tool at `translation`, in any direction"}};
  Output<double> roll{
      this, "roll", {.unit = "rad", .doc = "reached both ways at `translation`, in any direction"}};
  Output<double> tilt{
      this, "tilt", {.unit = "rad", .doc = "reached in every direction at `depth`"}};

  Parameter<double> translation{
      this,
      "translation",
      {.unit = "m", .initial = "0 mm", .min = "0 mm", .max = "1000 mm", .doc = "from the axis"}};
  Parameter<double> depth{this,
                          "depth",
                          {.unit = "m",
                           .initial = "85 mm",
                           .min = "0 mm",
                           .max = "2000 mm",
                           .doc = "of the ball joint behind the rings' plane"}};
  Parameter<std::int64_t> seed{
      this, "seed", {.initial = "1", .min = "0", .doc = "of the sampling's random shifts"}};
  Parameter<std::int64_t> tips = points("tips", "8192");
  Parameter<std::int64_t> poses = points("poses", "8192");
  LaparoscopeGeometryParameters geometry{this};
  LaparoscopeLimitParameters limits{this};

 private:
  Parameter<std::int64_t> points(const char* name, const char* initial) {
    return {
        this,
        name,
        {.initial = initial, .min = "256", .doc = "tried under each of 16 shifts; a power of 2"}};
  }
};

}  // namespace trocar
