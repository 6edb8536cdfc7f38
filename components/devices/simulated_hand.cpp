// SPDX-License-Identifier: Apache-2.0
#include "components/devices/simulated_hand.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "components/requirement.hpp"

namespace trocar {
namespace {

using Eigen::Vector3d;

void require_of_hand(bool holds, const std::string& what, double value, const char* allowed) {
  require(holds, "hand: " + what, value, std::string("needs ") + allowed);
}

struct Stroke {
  double depth = 0.0;  // relative
  double rate = 0.0;   // [1/s]
};

Stroke stroke(const PushSettings& push, double time) RT_SAFE {
  double s = time - push.start;
  if (s <= 0.0) return {};
  const double half = push.rise + push.dwell;
  bool inwards = true;
  if (std::isfinite(half)) {
    s = std::fmod(s, 2.0 * half);
    inwards = s < half;
    if (!inwards) s -= half;
  }
  Stroke result{1.0, 0.0};
  if (s < push.rise) {
    const double w = std::numbers::pi / push.rise;
    result = {0.5 - 0.5 * std::cos(w * s), 0.5 * w * std::sin(w * s)};
  }
  return inwards ? result : Stroke{1.0 - result.depth, -result.rate};
}

}  // namespace

SimulatedHand::SimulatedHand(const HandSettings& s) : settings_(s) {
  const auto at_least_0 = [](const char* what, double value) {
    require_of_hand(value >= 0.0 && std::isfinite(value), what, value, "a value of at least 0");
  };
  at_least_0("mass", s.mass);
  at_least_0("damping", s.damping);
  at_least_0("stiffness", s.stiffness);
  at_least_0("rotational_damping", s.rotational_damping);
  at_least_0("rotational_stiffness", s.rotational_stiffness);
  at_least_0("push.depth", s.push.depth);
  at_least_0("push.start", s.push.start);
  require_of_hand(s.push.rise > 0.0, "push.rise", s.push.rise, "a time above 0 s, e.g. 1.0");
  require_of_hand(s.push.dwell >= 0.0, "push.dwell", s.push.dwell,
                  "a time of at least 0 s, e.g. 1.0");
  require_of_hand(s.relaxed_grip >= 0.0 && s.relaxed_grip <= 1.0, "relaxed_grip", s.relaxed_grip,
                  "a share from 0 to 1");
  require_of_hand(s.push.bow.allFinite(), "length of push.bow", s.push.bow.norm(),
                  "finite numbers");
  const double length = s.push.direction.norm();
  require_of_hand(std::abs(length - 1.0) <= 1e-9, "length of push.direction", length,
                  "a unit vector, e.g. {0, 0, 1}");
  if (s.mode != HandMode::relaxed) return;
  for (double* each : {&settings_.damping, &settings_.stiffness, &settings_.rotational_damping,
                       &settings_.rotational_stiffness})
    *each *= s.relaxed_grip;
}

void SimulatedHand::grasp(const Tool::State& tool) RT_SAFE {
  rest_ = tool.tip;
  rest_rotation_ = tool.rotation;
}

Vector3d SimulatedHand::target(double time) const RT_SAFE {
  if (settings_.mode != HandMode::pushes) return rest_;
  const PushSettings& push = settings_.push;
  const double u = stroke(push, time).depth;
  return rest_ + push.depth * u * push.direction + 4.0 * u * (1.0 - u) * push.bow;
}

Vector3d SimulatedHand::target_velocity(double time) const RT_SAFE {
  if (settings_.mode != HandMode::pushes) return Vector3d::Zero();
  const PushSettings& push = settings_.push;
  const Stroke s = stroke(push, time);
  return s.rate * (push.depth * push.direction + 4.0 * (1.0 - 2.0 * s.depth) * push.bow);
}

Vector6d SimulatedHand::spring_wrench(const Tool::State& tool, double time) const RT_SAFE {
  if (!present()) return Vector6d::Zero();
  Vector6d wrench;
  wrench.head<3>() = settings_.stiffness * (target(time) - tool.tip);
  wrench.tail<3>() =
      settings_.rotational_stiffness * rotation_vector(rest_rotation_ * tool.rotation.transpose());
  return wrench;
}

double SimulatedHand::potential(const Tool::State& tool, double time) const RT_SAFE {
  if (!present()) return 0.0;
  const double turned = rotation_vector(rest_rotation_ * tool.rotation.transpose()).squaredNorm();
  return 0.5 * settings_.stiffness * (target(time) - tool.tip).squaredNorm() +
         0.5 * settings_.rotational_stiffness * turned;
}

Vector3d rotation_vector(const Eigen::Matrix3d& r) RT_SAFE {
  const Vector3d twice_sine(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  const double sine = 0.5 * twice_sine.norm();
  const double cosine = 0.5 * (r.trace() - 1.0);
  if (sine < 1e-9) return 0.5 * twice_sine;
  return 0.5 * std::atan2(sine, cosine) / sine * twice_sine;
}

}  // namespace trocar
