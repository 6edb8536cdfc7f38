// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_kinematics.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace trocar {
namespace {

constexpr double neutral_depth = 0.065;  // [m] of A behind the origin

std::vector<double> list(const Eigen::VectorXd& numbers) {
  return {numbers.data(), numbers.data() + numbers.size()};
}

Vector6d resolutions(const InputPort& input) {
  Vector6d counts;
  for (int i = 0; i < 6; ++i) counts[i] = input.resolution(static_cast<std::size_t>(i));
  return counts;
}

/// 3x6: velocity of the point E + s t from the axes' velocities.
Matrix36d point_jacobian(const LaparoscopeConfiguration& c, const LaparoscopeRates& rates,
                         double s) {
  Matrix36d jacobian;
  for (int i = 0; i < 6; ++i)
    jacobian.col(i) = velocity_at(c.tool, point_on_tool(c.tool, s), rates.jacobian.col(i));
  return jacobian;
}

}  // namespace

void LaparoscopeKinematics::configure(const Setup&) {
  model_.emplace(geometry.value());
  declare_quality();
}

void LaparoscopeKinematics::declare_quality() {
  Vector6d q;
  LaparoscopeConfiguration c;
  AssemblyStatus status =
      model_->inverse({{0.0, 0.0, *geometry.tool_length - neutral_depth}, 0.0, 0.0, 0.0}, q);
  if (status == AssemblyStatus::ok) status = model_->forward(q, c);
  if (status != AssemblyStatus::ok)
    throw std::invalid_argument(std::string("the geometry has no neutral pose (65 mm deep): ") +
                                describe(status) + "; check its lengths");
  const LaparoscopeRates rates = model_->rates(c);
  const Vector6d step = resolutions(position), speed = resolutions(velocity);
  const double delay = std::max(position.delay(), velocity.delay());

  const auto site = [&](OutputPort& output, double s) {
    const Matrix36d gain = point_jacobian(c, rates, s).cwiseAbs();
    output.quality = {delay, list((Vector6d() << gain * step, gain * speed).finished())};
  };
  site(tip, *sites.tip_offset);
  site(incision, *sites.incision_offset);
  site(handle, *sites.handle_offset);

  const Matrix6d gain = rates.jacobian.cwiseAbs();
  const Vector6d moved = gain * step;
  // Of a unit quaternion no component changes by more than half the angle.
  const double turned = 0.5 * moved.tail<3>().sum();
  pose.quality = {position.delay(), {moved[0], moved[1], moved[2], turned, turned, turned, turned}};
  twist.quality = {delay, list(gain * speed)};
  jacobian.quality = angles.quality = {position.delay(), {}};
}

void LaparoscopeKinematics::step(const Tick&) RT_SAFE {
  LaparoscopeConfiguration c;
  const AssemblyStatus status = model_->forward(position->head<6>(), c);
  if (status != AssemblyStatus::ok) return fail(describe(status));
  const Matrix6d j = model_->rates(c).jacobian;
  const Vector6d moving = j * velocity->head<6>();

  const auto site = [&](double s) {
    const Eigen::Vector3d point = point_on_tool(c.tool, s);
    return PointMotion{point, Eigen::Vector3d(velocity_at(c.tool, point, moving))};
  };
  *tip = site(*sites.tip_offset);
  *incision = site(*sites.incision_offset);
  *handle = site(*sites.handle_offset);
  *pose = {c.tool.tip, Rotation(Eigen::Quaterniond(c.tool.rotation))};
  twist->eigen() = moving;
  jacobian->head<6>() = j;
  const PoseCoordinates coordinates = c.tool.pose();
  *angles = {coordinates.alpha, coordinates.beta, coordinates.theta};
}

}  // namespace trocar
