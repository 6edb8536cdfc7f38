// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <array>

#include "cli/kinematics_rows.hpp"
#include "components/kinematics/laparoscope_dynamics.hpp"
#include "components/kinematics/laparoscope_limits.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

using Names = std::vector<std::string>;

const Names actuators = {"q1", "q2", "q3", "phi1", "phi2", "phi3"};
const Names six_dof = {"xd", "yd", "zd", "xt", "yt", "thetat"};
const Names pose = {"xe", "ye", "ze", "alpha", "beta", "theta"};

Names operator+(Names names, const Names& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

/// "J11" to "J66".
Names matrix(const std::string& name, int size) {
  Names names;
  for (int i = 1; i <= size; ++i)
    for (int j = 1; j <= size; ++j) names.push_back(fmt::format("{}{}{}", name, i, j));
  return names;
}

/// "c1" to "c6".
Names six(const std::string& name) {
  Names names;
  for (int i = 1; i <= 6; ++i) names.push_back(fmt::format("{}{}", name, i));
  return names;
}

/// "M11", "M12" to "M66", each pair once.
Names upper_triangle(const std::string& name) {
  Names names;
  for (int i = 1; i <= 6; ++i)
    for (int j = i; j <= 6; ++j) names.push_back(fmt::format("{}{}{}", name, i, j));
  return names;
}

template <typename Derived>
void append(std::vector<double>& values, const Eigen::MatrixBase<Derived>& m) {
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < m.cols(); ++j) values.push_back(m(i, j));
}

constexpr const char* gravity_not_finite = "gx, gy, gz: gravity must be finite, in m/s^2";

KinematicsResult refusal(AssemblyStatus status) {
  return {{}, describe(status), ""};
}

std::string limits_of(const LaparoscopeConfiguration& configuration) {
  const LimitSet violated = violated_limits(LaparoscopeLimits(), configuration);
  Names names;
  for (unsigned i = 0; i < LimitSet::count; ++i)
    if (violated.has(i)) names.emplace_back(LimitSet::name(i));
  return join(names, ";");
}

KinematicsResult forward(const KinematicsRow& row) {
  LaparoscopeConfiguration c;
  const AssemblyStatus status = LaparoscopeModel(row.geometry).forward(row.given, c);
  if (status != AssemblyStatus::ok) return refusal(status);
  const PoseCoordinates at = c.tool.pose();
  KinematicsResult result{{}, "", limits_of(c)};
  append(result.values, c.tool.coordinates());
  append(result.values, at.tip);
  append(result.values, Eigen::Vector3d(at.alpha, at.beta, at.theta));
  append(result.values, c.tool.rotation);
  return result;
}

KinematicsResult inverse(const KinematicsRow& row) {
  const LaparoscopeModel model(row.geometry);
  const Vector6d& p = row.given;
  Vector6d q;
  LaparoscopeConfiguration c;
  AssemblyStatus status = model.inverse({p.head<3>(), p[3], p[4], p[5]}, q);
  if (status == AssemblyStatus::ok) status = model.forward(q, c);
  if (status != AssemblyStatus::ok) return refusal(status);
  KinematicsResult result{{}, "", limits_of(c)};
  append(result.values, q);
  append(result.values, c.tool.coordinates());
  return result;
}

KinematicsResult jacobian(const KinematicsRow& row) {
  const LaparoscopeModel model(row.geometry);
  LaparoscopeConfiguration c;
  const AssemblyStatus status = model.forward(row.given, c);
  if (status != AssemblyStatus::ok) return refusal(status);
  KinematicsResult result{{}, "", limits_of(c)};
  append(result.values, model.rates(c).jacobian);
  return result;
}

KinematicsResult gravity(const KinematicsRow& row) {
  const LaparoscopeModel model(row.geometry);
  const LaparoscopeGravity weight(row.geometry, row.masses);
  if (!row.gravity.allFinite()) return {{}, gravity_not_finite, ""};
  LaparoscopeConfiguration c;
  const AssemblyStatus status = model.forward(row.given, c);
  if (status != AssemblyStatus::ok) return refusal(status);
  KinematicsResult result{{weight.potential(c, row.gravity)}, "", limits_of(c)};
  append(result.values, weight.effort(c, model.rates(c), row.gravity));
  return result;
}

constexpr const char* no_motion = "the moving parts have no inertia: the mass matrix is singular";

KinematicsResult dynamics(const KinematicsRow& row) {
  const LaparoscopeDynamics device(row.geometry, row.masses);
  if (!row.gravity.allFinite()) return {{}, gravity_not_finite, ""};
  if (!row.velocity.allFinite()) return {{}, "qd1 to qd6: a rate is not a finite number", ""};
  LaparoscopeConfiguration c;
  const AssemblyStatus status = device.model().forward(row.given, c);
  if (status != AssemblyStatus::ok) return refusal(status);
  const LaparoscopeRates rates = device.model().rates(c);
  const auto inertia = device.inertia(c, rates);
  const Vector6d bias = device.bias(c, rates, inertia, row.velocity).effort;
  const Vector6d weight = device.gravity().effort(c, rates, row.gravity);
  const Vector6d load = static_effort(rates, row.wrench);
  const auto factor = inertia.mass.llt();
  if (factor.info() != Eigen::Success) return {{}, no_motion, ""};
  KinematicsResult result{{}, "", limits_of(c)};
  for (Eigen::Index i = 0; i < 6; ++i)
    for (Eigen::Index j = i; j < 6; ++j) result.values.push_back(inertia.mass(i, j));
  append(result.values, bias);
  append(result.values, weight);
  append(result.values, load);
  append(result.values, factor.solve(row.effort + load - bias - weight));
  return result;
}

}  // namespace

std::span<const KinematicsQuestion> kinematics_questions() {
  static const std::array<KinematicsQuestion, 5> questions = {{
      {"fk", "Pose of the tool from the actuators' positions", actuators,
       six_dof + pose + matrix("R", 3), KinematicsOwn::geometry, forward},
      {"ik", "Actuators' positions from the pose of the tool", pose, actuators + six_dof,
       KinematicsOwn::geometry, inverse},
      {"jacobian", "Jacobian: (velocity of E; angular velocity) = J q'", actuators, matrix("J", 6),
       KinematicsOwn::geometry, jacobian},
      {"gravity", "Potential energy, and the effort that holds the device's weight", actuators,
       Names{"V"} + six("taug"), KinematicsOwn::weight, gravity},
      {"dynamics", "Mass matrix, bias, weight, and the acceleration under given efforts",
       actuators + six("qd"),
       upper_triangle("M") + six("c") + six("taug") + six("tau") + six("qdd"),
       KinematicsOwn::motion, dynamics},
  }};
  return questions;
}

}  // namespace trocar::cli
