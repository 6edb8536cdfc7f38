// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

#include "components/kinematics/laparoscope_limits.hpp"
#include "tests/support/csv_table.hpp"

namespace trocar::test {

inline LaparoscopeGeometry geometry_of(const CsvTable::Row& row) {
  return {.tool_length = row.number("l"),
          .ring_plane = row.number("zt"),
          .ring_radius = row.number("r"),
          .base_radius = row.number("Rb"),
          .platform_radius = row.number("Rp"),
          .link_length = row.number("L")};
}

inline LaparoscopeMasses masses_of(const CsvTable::Row& row) {
  LaparoscopeMasses m;
  m.slider = row.number("m_sl");
  m.link_pair = row.number("m_lk");
  m.platform = row.number("m_pl");
  m.tool = row.number("m_tool");
  m.tool_centre = row.number("s_tool");
  m.end_effector = row.number("m_ee");
  m.pin = row.number("m_pin");
  return m;
}

inline Vector6d actuators_of(const CsvTable::Row& row) {
  return row.vector({"q1", "q2", "q3", "phi1", "phi2", "phi3"});
}

inline PoseCoordinates pose_of(const CsvTable::Row& row) {
  return {row.vector({"xe", "ye", "ze"}), row.number("alpha"), row.number("beta"),
          row.number("theta")};
}

/// Poses of the default geometry, drawn evenly from a box and kept when inside all limits.
inline std::vector<PoseCoordinates> random_reachable_poses(std::size_t count) {
  const LaparoscopeModel model;
  const LaparoscopeLimits limits;
  std::mt19937_64 engine(20240607);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  std::vector<PoseCoordinates> poses;
  while (poses.size() < count) {
    PoseCoordinates p;
    p.tip = {uniform(-0.13, 0.13), uniform(-0.13, 0.13), uniform(0.02, 0.145)};
    p.alpha = uniform(-0.78, 0.78);
    p.beta = uniform(-0.78, 0.78);
    p.theta = uniform(-4.0, 4.0);
    if (reachable(model, limits, p)) poses.push_back(p);
  }
  return poses;
}

/// Largest |a - b| over the largest |b|.
inline double relative_error(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// Derivative of f at 0 by central differences of sixth order. @param h step
template <typename F>
auto sixth_order_derivative(F&& f, double h) {
  using Value = std::decay_t<decltype(f(0.0))>;
  const Value d = 45.0 * (f(h) - f(-h)) - 9.0 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h));
  return Value(d / (60.0 * h));
}

}  // namespace trocar::test
