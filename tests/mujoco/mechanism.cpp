// SPDX-License-Identifier: Apache-2.0
#include "tests/mujoco/mechanism.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace trocar::test {
namespace {

using Eigen::Vector3d;

constexpr double no_inertia = 1e-14;    // [kg m^2]
constexpr double any_inertia = 1e-3;    // [kg m^2], of what does not turn
constexpr double any_mass = 1.0;        // [kg], of what does not move
constexpr double half_of_pair = 0.025;  // [m], between an arm's rods, halved; in no result

double angle(int i) {
  return 2.0 * std::numbers::pi / 3.0 * i;
}
Vector3d radial(int i) {
  return {std::cos(angle(i)), std::sin(angle(i)), 0.0};
}
Vector3d tangential(int i) {
  return {-std::sin(angle(i)), std::cos(angle(i)), 0.0};
}

std::string text(const Vector3d& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

std::string inertial(double mass, const Vector3d& inertia, const Vector3d& centre) {
  return fmt::format("<inertial pos='{}' mass='{}' diaginertia='{}'/>\n", text(centre), mass,
                     text(inertia));
}

std::string inertial(double mass, double inertia) {
  return inertial(mass, Vector3d::Constant(inertia), Vector3d::Zero());
}

std::string site(const std::string& name, const Vector3d& at) {
  return fmt::format("<site name='{}' pos='{}'/>\n", name, text(at));
}

/// Writes the tree in its reference: tool upright on the axis, half of it behind the gimbal.
class Writer {
 public:
  Writer(const LaparoscopeGeometry& geometry, const LaparoscopeMasses& masses)
      : g_(geometry), m_(masses) {}

  Mechanism write() {
    for (int i = 0; i < 3; ++i) arm(i);
    platform();
    for (int i = 0; i < 3; ++i) ring(i);
    star();
    out_.mjcf = "<mujoco><compiler angle='radian'/><worldbody>\n" + xml_ + "</worldbody></mujoco>";
    return out_;
  }

 private:
  double platform_height() const { return g_.ring_plane - 0.5 * g_.tool_length; }

  void arm(int i) {
    const double reach = g_.base_radius - g_.platform_radius;
    const double rise = std::sqrt(g_.link_length * g_.link_length - reach * reach);
    const double height = platform_height() - rise;
    const Vector3d along = Vector3d(0.0, 0.0, rise) - reach * radial(i);
    xml_ += fmt::format("<body pos='{}'>\n<joint name='q{}' type='slide' axis='0 0 1' ref='{}'/>\n",
                        text(g_.base_radius * radial(i) + Vector3d(0.0, 0.0, height)), i, height);
    xml_ += inertial(m_.slider, any_inertia);
    for (const int side : {-1, 1}) {
      const double mass = 0.5 * m_.link_pair;
      const double across = mass * g_.link_length * g_.link_length / 12.0;
      const std::string name = fmt::format("{}{}", i, side);
      xml_ += fmt::format("<body pos='{}' zaxis='{}'>\n", text(side * half_of_pair * tangential(i)),
                          text(along));
      xml_ += "<joint axis='1 0 0'/><joint axis='0 1 0'/>\n";
      xml_ += inertial(mass, {across, across, no_inertia}, {0.0, 0.0, 0.5 * g_.link_length});
      xml_ += site("rod" + name, {0.0, 0.0, g_.link_length}) + "</body>\n";
      out_.sites.push_back({"rod" + name, "seat" + name});
    }
    xml_ += "</body>\n";
  }

  void platform() {
    xml_ += fmt::format("<body pos='0 0 {}'>\n<freejoint/>\n", platform_height());
    xml_ += inertial(m_.platform, any_inertia) + site("ball", Vector3d::Zero());
    for (int i = 0; i < 3; ++i)
      for (const int side : {-1, 1})
        xml_ += site(fmt::format("seat{}{}", i, side),
                     g_.platform_radius * radial(i) + side * half_of_pair * tangential(i));
    xml_ += "</body>\n";
  }

  void ring(int i) {
    xml_ += fmt::format("<body pos='0 0 {}'>\n<joint name='phi{}' axis='0 0 1' ref='{}'/>\n",
                        g_.ring_plane, i, angle(i));
    xml_ += inertial(any_mass, m_.ring - m_.pin * g_.ring_radius * g_.ring_radius);
    xml_ += site(fmt::format("hole{}", i), g_.ring_radius * radial(i)) + "</body>\n";
    out_.sites.push_back({fmt::format("pin{}", i), fmt::format("hole{}", i), 2});
  }

  void star() {
    xml_ += fmt::format("<body name='star' pos='0 0 {}'>\n", g_.ring_plane);
    xml_ += "<joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/>\n";
    xml_ += "<joint name='theta' axis='0 0 1'/>\n";
    xml_ += inertial(m_.end_effector / 2.0, m_.end_effector_spin);
    xml_ += site("gimbal", Vector3d::Zero());
    for (int i = 0; i < 3; ++i) {
      xml_ += fmt::format("<body pos='{}'>\n<joint type='slide' axis='{}'/>\n",
                          text(g_.ring_radius * radial(i)), text(radial(i)));
      xml_ += inertial(m_.pin, no_inertia) + site(fmt::format("pin{}", i), Vector3d::Zero());
      xml_ += "</body>\n";
    }
    gimbal();
    xml_ += "</body>\n";
  }

  void gimbal() {
    std::vector<std::string> hinges{"0 1 0", "1 0 0"};
    if (g_.roll == RollModel::gimbal_outer_x) hinges = {"1 0 0", "0 1 0"};
    if (g_.roll == RollModel::zero_torsion) hinges.emplace_back("0 1 0");
    out_.outer_hinges_equal = hinges.size() == 3;
    const double mass = m_.end_effector / 2.0 / static_cast<double>(hinges.size());
    for (std::size_t i = 0; i < hinges.size(); ++i) {
      xml_ += fmt::format("<body>\n<joint name='gimbal{}' axis='{}'/>\n", i, hinges[i]);
      xml_ += inertial(mass, no_inertia);
    }
    tool();
    for (std::size_t i = 0; i < hinges.size(); ++i) xml_ += "</body>\n";
  }

  void tool() {
    xml_ += fmt::format("<body name='tool' pos='0 0 {}'>\n", -0.5 * g_.tool_length);
    xml_ += "<joint type='slide' axis='0 0 1'/>\n";
    xml_ += inertial(m_.tool, {m_.tool_transverse, m_.tool_transverse, m_.tool_axial},
                     {0.0, 0.0, m_.tool_centre});
    xml_ += site("tool_end", Vector3d::Zero()) + site("tip", {0.0, 0.0, g_.tool_length});
    xml_ += "</body>\n";
    out_.sites.push_back({"tool_end", "ball"});
  }

  const LaparoscopeGeometry& g_;
  const LaparoscopeMasses& m_;
  std::string xml_;
  Mechanism out_;
};

}  // namespace

Mechanism mechanism(const LaparoscopeGeometry& g, const LaparoscopeMasses& m) {
  return Writer(g, m).write();
}

}  // namespace trocar::test
