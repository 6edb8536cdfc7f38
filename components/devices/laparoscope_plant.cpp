// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope_plant.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "components/devices/coulomb_friction.hpp"

namespace trocar {

LaparoscopePlant::LaparoscopePlant(const LaparoscopePlantSettings& s)
    : dynamics_(s.geometry, s.masses),
      drive_(s.drive, s.imperfections, s.seed),
      temperature_(s.drive, s.imperfections),
      stops_(s.stops, s.limits, s.geometry),
      hand_(s.hand),
      gravity_(s.gravity) {
  if (!s.gravity.allFinite())
    throw std::invalid_argument("plant: gravity needs three finite numbers in m/s^2");
  if (s.imperfections.compliance) {
    springs_.emplace(s.drive, both(s.masses.slider, s.masses.ring));
    motor_weight_.head<3>().setConstant(s.drive.slider.motor_inertia * s.gravity.z());
  }
  Vector6d q;
  const AssemblyStatus status = dynamics_.model().inverse(s.start, q);
  if (status != AssemblyStatus::ok)
    throw std::invalid_argument(std::string("plant: starting pose cannot be assembled: ") +
                                describe(status) + "; start inside the workspace");
  place(q, Vector6d::Zero());
  hand_.grasp(here_.tool);
}

void LaparoscopePlant::place(const Vector6d& q, const Vector6d& velocity) {
  LaparoscopeConfiguration configuration;
  const AssemblyStatus status = dynamics_.model().forward(q, configuration);
  if (status != AssemblyStatus::ok)
    throw std::invalid_argument(std::string("plant: position cannot be assembled: ") +
                                describe(status));
  if (!velocity.allFinite())
    throw std::invalid_argument("plant: velocity needs six finite numbers");
  here_ = configuration;
  q_ = q;
  v_ = v_before_ = velocity;
  status_ = AssemblyStatus::ok;
  if (!springs_) return;
  const LaparoscopeRates rates = dynamics_.model().rates(configuration);
  const Vector6d weight = dynamics_.gravity().effort(configuration, rates, gravity_);
  springs_->rest(q, velocity, weight + motor_weight_);
}

int LaparoscopePlant::substeps(double duration) RT_SAFE {
  constexpr double longest = 1e-4;
  return std::max(4, static_cast<int>(std::ceil(duration / longest - 1e-6)));
}

void LaparoscopePlant::advance(double duration, int substeps) RT_SAFE {
  const double h = duration / substeps;
  pull_ = temperature_.gain().cwiseProduct(sent_);
  for (int i = 0; i < substeps && status_ == AssemblyStatus::ok; ++i)
    step(h, time_ + (i + 0.5) * h);
  time_ += duration;
  settle();
  temperature_.advance(duration, sent_);
  sent_ = temperature_.limited(command_);
}

// Drift, kick, drift; `time` is that of the kick.
void LaparoscopePlant::step(double h, double time) RT_SAFE {
  q_ += 0.5 * h * v_;
  if (springs_) springs_->drift(0.5 * h);
  LaparoscopeConfiguration middle;
  status_ = dynamics_.model().forward(q_, middle);
  if (status_ != AssemblyStatus::ok) return;
  const Actions a = actions(middle, time);
  const Vector6d next = springs_ ? kick_apart(h, a) : kick_as_one(h, a);
  v_before_ = v_;
  v_ = next;
  q_ += 0.5 * h * v_;
  if (springs_) springs_->drift(0.5 * h);
}

Vector6d LaparoscopePlant::kick_as_one(double h, const Actions& a) const RT_SAFE {
  Matrix6d damping = a.damping;
  damping.diagonal() += drive_.viscous();
  const Vector6d effort = drive_.effort(pull_, q_) + a.effort;
  const Vector6d impulse = a.mass * v_ + h * (effort - 0.5 * (damping * v_));
  Vector6d next = v_;
  velocity_with_friction(a.mass + 0.5 * h * damping, impulse, h * drive_.dry_friction(v_), next);
  return next;
}

Vector6d LaparoscopePlant::kick_apart(double h, const Actions& a) RT_SAFE {
  Matrix6d mass = a.mass;
  mass.diagonal() -= springs_->inertia();
  const Vector6d spring = springs_->effort(q_, v_);
  const Vector6d effort = spring + a.effort - motor_weight_;
  const Vector6d impulse = mass * v_ + h * (effort - 0.5 * (a.damping * v_));
  const Vector6d drive = drive_.effort(pull_, springs_->position());
  springs_->kick(h, drive + motor_weight_ - spring, drive_.viscous(),
                 drive_.dry_friction(springs_->velocity()));
  return Eigen::LLT<Matrix6d>(mass + 0.5 * h * a.damping).solve(impulse);
}

LaparoscopePlant::Actions LaparoscopePlant::actions(const LaparoscopeConfiguration& c,
                                                    double time) const RT_SAFE {
  const LaparoscopeRates rates = dynamics_.model().rates(c);
  const auto inertia = dynamics_.inertia(c, rates);
  // Half a step ahead of v_, where the kick stands.
  const auto bias = dynamics_.bias(c, rates, inertia, 1.5 * v_ - 0.5 * v_before_);
  const EndStops::Reaction stops = stops_.reaction(c, rates, v_);
  Actions sum;
  sum.mass = inertia.mass;
  sum.damping.setZero();
  sum.effort = static_effort(rates, external_) - bias.effort -
               dynamics_.gravity().effort(c, rates, gravity_);
  if (stops.any) {
    sum.damping += stops.damping;
    sum.effort += stops.effort;
  }
  if (hand_.present()) add_hand(c, rates, bias, time, sum);
  return sum;
}

void LaparoscopePlant::add_hand(const LaparoscopeConfiguration& c, const LaparoscopeRates& rates,
                                const LaparoscopeDynamics::Bias& bias, double time,
                                Actions& sum) const RT_SAFE {
  const HandSettings& hand = hand_.settings();
  const Matrix36d jv = rates.jacobian.topRows<3>(), jw = rates.jacobian.bottomRows<3>();
  const Matrix6d along = jv.transpose().lazyProduct(jv);
  sum.mass += hand.mass * along;
  sum.damping += hand.damping * along;
  sum.damping += hand.rotational_damping * jw.transpose().lazyProduct(jw);
  Vector6d wrench = hand_.spring_wrench(c.tool, time);
  wrench.head<3>() += hand.damping * hand_.target_velocity(time) - hand.mass * bias.tip;
  sum.effort += static_effort(rates, wrench);
}

void LaparoscopePlant::settle() RT_SAFE {
  LaparoscopeConfiguration now;
  if (status_ == AssemblyStatus::ok) status_ = dynamics_.model().forward(q_, now);
  if (status_ == AssemblyStatus::ok) {
    here_ = now;
    return;
  }
  q_ = here_.q;
  v_.setZero();
  v_before_.setZero();
  if (springs_) springs_->rest(q_, v_, Vector6d::Zero());
}

double LaparoscopePlant::energy() const RT_SAFE {
  const LaparoscopeRates rates = dynamics_.model().rates(here_);
  Matrix6d mass = dynamics_.inertia(here_, rates).mass;
  if (springs_) mass.diagonal() -= springs_->inertia();
  double energy = 0.5 * v_.dot(mass * v_) + dynamics_.gravity().potential(here_, gravity_) +
                  stops_.reaction(here_, rates, v_).potential;
  if (springs_) energy += springs_->energy(q_) - motor_weight_.dot(springs_->position() - q_);
  if (hand_.present())
    energy += 0.5 * hand_.settings().mass * (rates.jacobian.topRows<3>() * v_).squaredNorm() +
              hand_.potential(here_.tool, time_);
  return energy;
}

}  // namespace trocar
