// SPDX-License-Identifier: Apache-2.0
#include "tests/mujoco/closed_mechanism.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace trocar::test {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

mjModel* load(const std::string& mjcf) {
  const auto files = std::make_unique<mjVFS>();  // megabytes, not for the stack
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "mechanism.xml", static_cast<int>(mjcf.size()));
  std::memcpy(files->filedata[0], mjcf.data(), mjcf.size());
  std::array<char, 1000> error{};
  mjModel* model =
      mj_loadXML("mechanism.xml", files.get(), error.data(), static_cast<int>(error.size()));
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(error.data());
  return model;
}

}  // namespace

ClosedMechanism::ClosedMechanism(const Mechanism& mechanism)
    : model_(load(mechanism.mjcf), mj_deleteModel),
      data_(mj_makeData(model_.get()), mj_deleteData) {
  std::size_t k = 0;
  for (const char* name : {"q0", "q1", "q2", "phi0", "phi1", "phi2"}) {
    const int joint = id(mjOBJ_JOINT, name);
    actuators_[k] = model_->jnt_dofadr[joint];
    positions_[k++] = model_->jnt_qposadr[joint];
  }
  for (int i = 0; i < model_->nv; ++i)
    if (std::find(actuators_.begin(), actuators_.end(), i) == actuators_.end())
      dependent_.push_back(i);
  for (const auto& c : mechanism.sites) {
    loops_.push_back({id(mjOBJ_SITE, c.one), id(mjOBJ_SITE, c.other), c.axes});
    equations_ += c.axes;
  }
  if (mechanism.outer_hinges_equal) {
    for (const char* name : {"gimbal0", "gimbal2"})
      equal_hinges_.push_back(model_->jnt_dofadr[id(mjOBJ_JOINT, name)]);
    ++equations_;
  }
  if (equations_ != static_cast<Index>(dependent_.size()))
    throw std::runtime_error("the loops do not leave six degrees of freedom");
}

int ClosedMechanism::id(mjtObj kind, const std::string& name) const {
  const int found = mj_name2id(model_.get(), kind, name.c_str());
  if (found < 0) throw std::runtime_error("no part is called " + name);
  return found;
}

double ClosedMechanism::assemble(const Vector6d& q) {
  mj_resetData(model_.get(), data_.get());
  Vector6d from;
  for (Index i = 0; i < 6; ++i) from[i] = data_->qpos[positions_[static_cast<std::size_t>(i)]];
  constexpr int parts = 40;  // small enough to stay on the branch of the reference
  double left = 0.0;
  for (int part = 1; part <= parts; ++part) {
    const Vector6d to = part == parts ? q : Vector6d(from + (q - from) * part / parts);
    for (Index i = 0; i < 6; ++i) data_->qpos[positions_[static_cast<std::size_t>(i)]] = to[i];
    left = newton(part == parts ? 0.0 : 1e-6);
  }
  mju_zero(data_->qvel, model_->nv);
  mj_fwdPosition(model_.get(), data_.get());
  const Matrix jacobian = loop_jacobian();
  s_.resize(model_->nv, 6);
  for (Index i = 0; i < 6; ++i) {
    const int actuator = actuators_[static_cast<std::size_t>(i)];
    s_.col(i) = solve_dependent(jacobian, -jacobian.col(actuator));
    s_(actuator, i) = 1.0;
  }
  return left;
}

double ClosedMechanism::newton(double enough) {
  for (int step = 0;; ++step) {
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    const VectorXd distances = loop_distances();
    const double left = distances.cwiseAbs().maxCoeff();
    if (left <= enough || step == 8) return left;  // round-off seldom lets 0 be reached
    const VectorXd move = solve_dependent(loop_jacobian(), -distances);
    mj_integratePos(model_.get(), data_->qpos, move.data(), 1.0);
  }
}

VectorXd ClosedMechanism::solve_dependent(const Matrix& jacobian, const VectorXd& right) const {
  const Eigen::MatrixXd square = jacobian(Eigen::all, dependent_);
  const VectorXd solution = square.partialPivLu().solve(right);
  VectorXd all = VectorXd::Zero(model_->nv);
  all(dependent_) = solution;
  return all;
}

VectorXd ClosedMechanism::loop_distances() const {
  VectorXd r(equations_);
  Index row = 0;
  for (const Loop& loop : loops_)
    for (int i = 0; i < loop.axes; ++i)
      r[row++] = data_->site_xpos[3 * loop.one + i] - data_->site_xpos[3 * loop.other + i];
  if (!equal_hinges_.empty()) {
    const auto angle = [&](int dof) {
      return data_->qpos[model_->jnt_qposadr[model_->dof_jntid[dof]]];
    };
    r[row] = angle(equal_hinges_[0]) - angle(equal_hinges_[1]);
  }
  return r;
}

ClosedMechanism::Matrix ClosedMechanism::loop_jacobian() const {
  Matrix j = Matrix::Zero(equations_, model_->nv);
  Index row = 0;
  for (const Loop& loop : loops_) {
    const Matrix between = site_jacobian(loop.one) - site_jacobian(loop.other);
    j.middleRows(row, loop.axes) = between.topRows(loop.axes);
    row += loop.axes;
  }
  if (!equal_hinges_.empty()) {
    j(row, equal_hinges_[0]) = 1.0;
    j(row, equal_hinges_[1]) = -1.0;
  }
  return j;
}

VectorXd ClosedMechanism::loop_drift() const {
  VectorXd drift = VectorXd::Zero(equations_);
  Index row = 0;
  for (const Loop& loop : loops_) {
    const Vector6d between = site_acceleration(loop.one) - site_acceleration(loop.other);
    drift.segment(row, loop.axes) = between.head(loop.axes);
    row += loop.axes;
  }
  return drift;
}

ClosedMechanism::Matrix ClosedMechanism::site_jacobian(int site) const {
  Matrix j(6, model_->nv);
  mj_jacSite(model_.get(), data_.get(), j.data(), j.row(3).data(), site);
  return j;
}

Vector6d ClosedMechanism::site_acceleration(int site) const {
  Vector6d angular_first;
  mj_objectAcceleration(model_.get(), data_.get(), mjOBJ_SITE, site, angular_first.data(), 0);
  return (Vector6d() << angular_first.tail<3>(), angular_first.head<3>()).finished();
}

Vector3d ClosedMechanism::place(const char* site) const {
  return Eigen::Map<const Vector3d>(data_->site_xpos + Index{3} * id(mjOBJ_SITE, site));
}

Matrix3d ClosedMechanism::tool_rotation() const {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
      data_->xmat + Index{9} * id(mjOBJ_BODY, "tool"));
}

Matrix6d ClosedMechanism::jacobian() const {
  return site_jacobian(id(mjOBJ_SITE, "tip")) * s_;
}

Matrix6d ClosedMechanism::mass() const {
  Matrix m(model_->nv, model_->nv);
  mj_fullM(model_.get(), m.data(), data_->qM);
  return s_.transpose() * m * s_;
}

void ClosedMechanism::tree_velocity(const VectorXd& v) {
  mju_copy(data_->qvel, v.data(), model_->nv);
  mj_fwdVelocity(model_.get(), data_.get());
}

Vector6d ClosedMechanism::holding_effort(const Vector3d& gravity) {
  mju_copy3(model_->opt.gravity, gravity.data());
  tree_velocity(VectorXd::Zero(model_->nv));
  return s_.transpose() * Eigen::Map<const VectorXd>(data_->qfrc_bias, model_->nv);
}

ClosedMechanism::Bias ClosedMechanism::bias(const Vector6d& velocity) {
  mju_zero3(model_->opt.gravity);
  tree_velocity(s_ * velocity);
  mju_zero(data_->qacc, model_->nv);
  mj_rnePostConstraint(model_.get(), data_.get());
  const VectorXd a = solve_dependent(loop_jacobian(), -loop_drift());
  VectorXd inertial(model_->nv);
  mj_mulM(model_.get(), data_.get(), inertial.data(), a.data());

  mju_copy(data_->qacc, a.data(), model_->nv);
  mj_rnePostConstraint(model_.get(), data_.get());
  const Vector6d tip = site_acceleration(id(mjOBJ_SITE, "tip"));
  return {s_.transpose() * (Eigen::Map<const VectorXd>(data_->qfrc_bias, model_->nv) + inertial),
          jacobian() * velocity, tip.head<3>(), tip.tail<3>()};
}

}  // namespace trocar::test
