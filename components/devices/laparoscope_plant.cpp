// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope_plant.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "components/devices/coulomb_friction.hpp"

namespace trocar {

LaparoscopePlant::LaparoscopePlant(const LaparoscopePlantSettings& s)
    : dynamics_(s.geometry, s.masses),
      drive_(s.drive, s.imperfections, s.seed),
      stops_(s.stops, s.limits, s.geometry),
      hand_(s.hand),
      gravity_(s.gravity) {
  if (!s.gravity.allFinite())
    throw std::invalid_argument("plant: gravity needs three finite numbers in m/s^2");
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
}

int LaparoscopePlant::substeps(double duration) RT_SAFE {
  constexpr double longest = 1e-4;
  return std::max(4, static_cast<int>(std::ceil(duration / longest - 1e-6)));
}

void LaparoscopePlant::advance(double duration, int substeps) RT_SAFE {
  const double h = duration / substeps;
  for (int i = 0; i < substeps && status_ == AssemblyStatus::ok; ++i)
    step(h, time_ + (i + 0.5) * h);
  time_ += duration;
  settle();
}

// Drift, kick, drift; `time` is that of the kick.
void LaparoscopePlant::step(double h, double time) RT_SAFE {
  q_ += 0.5 * h * v_;
  LaparoscopeConfiguration middle;
  status_ = dynamics_.model().forward(q_, middle);
  if (status_ != AssemblyStatus::ok) return;
  const Actions a = actions(middle, time);
  const Vector6d impulse = a.mass * v_ + h * (a.effort - 0.5 * (a.damping * v_));
  Vector6d next = v_;
  velocity_with_friction(a.mass + 0.5 * h * a.damping, impulse, h * drive_.coulomb(), next);
  v_before_ = v_;
  v_ = next;
  q_ += 0.5 * h * v_;
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
  sum.damping = drive_.viscous().asDiagonal();
  sum.effort = drive_.effort(sent_, c.q) - bias.effort -
               dynamics_.gravity().effort(c, rates, gravity_) + static_effort(rates, external_);
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
}

double LaparoscopePlant::energy() const RT_SAFE {
  const LaparoscopeRates rates = dynamics_.model().rates(here_);
  const Matrix6d mass = dynamics_.inertia(here_, rates).mass;
  double energy = 0.5 * v_.dot(mass * v_) + dynamics_.gravity().potential(here_, gravity_) +
                  stops_.reaction(here_, rates, v_).potential;
  if (hand_.present())
    energy += 0.5 * hand_.settings().mass * (rates.jacobian.topRows<3>() * v_).squaredNorm() +
              hand_.potential(here_.tool, time_);
  return energy;
}

}  // namespace trocar
