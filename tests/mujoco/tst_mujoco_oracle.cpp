// SPDX-License-Identifier: Apache-2.0
// The laparoscope's kinematics, weight and dynamics against MuJoCo's bodies, at random states.
#include <Eigen/Cholesky>
#include <QTest>
#include <algorithm>
#include <random>

#include "components/kinematics/laparoscope_dynamics.hpp"
#include "tests/mujoco/closed_mechanism.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;
using Eigen::Vector3d;

namespace {

constexpr std::size_t states = 250;  // of each device

struct Device {
  LaparoscopeGeometry geometry;
  LaparoscopeMasses masses;
};

Device with_roll(RollModel roll) {
  return {{.roll = roll}, {}};
}

/// No length and no mass is the default one.
Device another() {
  return {{.tool_length = 0.180,
           .ring_plane = 0.031,
           .ring_radius = 0.105,
           .base_radius = 0.155,
           .platform_radius = 0.033,
           .link_length = 0.240},
          {.slider = 0.410,
           .link_pair = 0.090,
           .platform = 0.075,
           .tool = 0.200,
           .tool_centre = 0.080,
           .tool_transverse = 5e-4,
           .tool_axial = 3e-5,
           .end_effector = 0.170,
           .end_effector_spin = 4e-4,
           .pin = 0.040,
           .ring = 3e-3}};
}

struct State {
  Vector6d q, velocity, effort, wrench;
  Vector3d gravity;  // of a device that is mounted anyhow
};

std::vector<State> random_states(const LaparoscopeModel& model, std::size_t count) {
  std::mt19937_64 engine(20250311);
  const auto uniform = [&](double most) {
    return most * (static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0);
  };
  const auto parts = [&](double first, double last) {
    Vector6d v;
    for (int i = 0; i < 6; ++i) v[i] = uniform(i < 3 ? first : last);
    return v;
  };
  std::vector<State> list;
  for (const PoseCoordinates& pose : random_reachable_poses(2 * count)) {
    State s;
    if (model.inverse(pose, s.q) != AssemblyStatus::ok) continue;
    s.velocity = parts(0.5, 3.0);   // [m/s, rad/s]
    s.effort = parts(200.0, 12.0);  // [N, N m], the drives' peaks
    s.wrench = parts(20.0, 1.0);    // [N, N m]
    s.gravity = standard_gravity.norm() * parts(1.0, 1.0).head<3>().normalized();
    list.push_back(s);
    if (list.size() == count) break;
  }
  return list;
}

/// |a - b| over |b|, sliders (or linear) and rings (or angular) each by themselves.
double relative(const Vector6d& a, const Vector6d& b) {
  return std::max((a - b).head<3>().norm() / b.head<3>().norm(),
                  (a - b).tail<3>().norm() / b.tail<3>().norm());
}

/// Largest differences over all states; NaN stays.
struct Figures {
  std::size_t count = 0;
  double loops = 0.0;         // left open in MuJoCo's mechanism [m, rad]
  double place = 0.0;         // of A, B, E [m]
  double rotation = 0.0;      // entries of R
  double twist = 0.0;         // relative, as all below
  double mass = 0.0;          // entries of D M D; D makes MuJoCo's diagonal 1
  double holding = 0.0;       // tau_g
  double loaded = 0.0;        // tau_g - J^T F
  double bias = 0.0;          // c
  double tip = 0.0;           // E'' and omega' when q'' = 0
  double acceleration = 0.0;  // q''
};

void raise(double& most, double value) {
  if (!(value <= most)) most = value;
}

Vector6d acceleration(const Matrix6d& mass, const Matrix6d& jacobian, const Vector6d& bias,
                      const Vector6d& holding, const State& s) {
  return mass.llt().solve(s.effort + jacobian.transpose() * s.wrench - bias - holding);
}

Vector6d stacked(const Vector3d& a, const Vector3d& b) {
  return (Vector6d() << a, b).finished();
}

void compare(const LaparoscopeDynamics& ours, ClosedMechanism& theirs, const State& s,
             Figures& figures) {
  LaparoscopeConfiguration c;
  if (ours.model().forward(s.q, c) != AssemblyStatus::ok) return;
  const LaparoscopeRates rates = ours.model().rates(c);
  const auto inertia = ours.inertia(c, rates);
  const auto bias = ours.bias(c, rates, inertia, s.velocity);
  const Vector6d holding = ours.gravity().effort(c, rates, s.gravity);
  const Vector6d q2 = acceleration(inertia.mass, rates.jacobian, bias.effort, holding, s);

  Figures& f = figures;
  ++f.count;
  raise(f.loops, theirs.assemble(s.q));
  raise(f.place, (theirs.place("ball") - c.tool.ball).norm());
  raise(f.place, (theirs.place("gimbal") - c.tool.gimbal).norm());
  raise(f.place, (theirs.place("tip") - c.tool.tip).norm());
  raise(f.rotation, (theirs.tool_rotation() - c.tool.rotation).cwiseAbs().maxCoeff());

  const Matrix6d mass = theirs.mass(), jacobian = theirs.jacobian();
  const Vector6d scale = mass.diagonal().cwiseSqrt().cwiseInverse();
  raise(f.mass,
        (scale.asDiagonal() * (inertia.mass - mass) * scale.asDiagonal()).cwiseAbs().maxCoeff());
  const Vector6d their_holding = theirs.holding_effort(s.gravity);
  raise(f.holding, relative(holding, their_holding));
  raise(f.loaded, relative(holding - static_effort(rates, s.wrench),
                           their_holding - jacobian.transpose() * s.wrench));
  const auto their_bias = theirs.bias(s.velocity);
  raise(f.twist, relative(bias.twist, their_bias.twist));
  raise(f.bias, relative(bias.effort, their_bias.effort));
  raise(f.tip,
        relative(stacked(bias.tip, bias.angular), stacked(their_bias.tip, their_bias.angular)));
  raise(f.acceleration,
        relative(q2, acceleration(mass, jacobian, their_bias.effort, their_holding, s)));
}

Figures compare(const Device& ours, const Device& theirs, std::size_t count) {
  const LaparoscopeDynamics model(ours.geometry, ours.masses);
  ClosedMechanism oracle(mechanism(theirs.geometry, theirs.masses));
  Figures figures;
  for (const State& s : random_states(model.model(), count)) compare(model, oracle, s, figures);
  return figures;
}

}  // namespace

Q_DECLARE_METATYPE(Device)

class TestMujocoOracle : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_model_is_that_of_the_bodies_data() {
    QTest::addColumn<Device>("device");
    QTest::newRow("default: gimbal, outer axis y") << Device{};
    QTest::newRow("gimbal, outer axis x") << with_roll(RollModel::gimbal_outer_x);
    QTest::newRow("zero torsion") << with_roll(RollModel::zero_torsion);
    QTest::newRow("other lengths and masses") << another();
  }
  void the_model_is_that_of_the_bodies() {
    QFETCH(Device, device);
    const Figures f = compare(device, device, states);
    qInfo("%zu states, loops closed to %.1e; A, B, E %.1e m, R %.1e, twist %.1e", f.count, f.loops,
          f.place, f.rotation, f.twist);
    qInfo(
        "holding effort %.1e, with a hand %.1e, mass %.1e, bias %.1e, tip and tool when q'' = 0 "
        "%.1e, acceleration %.1e",
        f.holding, f.loaded, f.mass, f.bias, f.tip, f.acceleration);
    QCOMPARE(f.count, states);
    QVERIFY(f.loops <= 1e-14);
    QVERIFY(f.place <= 1e-9);
    QVERIFY(f.rotation <= 1e-9);
    QVERIFY(f.twist <= 1e-9);
    QVERIFY(f.holding <= 1e-6);
    QVERIFY(f.loaded <= 1e-6);
    QVERIFY(f.mass <= 1e-6);
    QVERIFY(f.bias <= 1e-5);
    QVERIFY(f.tip <= 1e-5);
    QVERIFY(f.acceleration <= 1e-5);
  }

  void a_mass_that_differs_is_noticed_data() {
    QTest::addColumn<double LaparoscopeMasses::*>("mass");
    QTest::newRow("slider") << &LaparoscopeMasses::slider;
    QTest::newRow("link_pair") << &LaparoscopeMasses::link_pair;
    QTest::newRow("platform") << &LaparoscopeMasses::platform;
    QTest::newRow("tool") << &LaparoscopeMasses::tool;
    QTest::newRow("tool_centre") << &LaparoscopeMasses::tool_centre;
    QTest::newRow("tool_transverse") << &LaparoscopeMasses::tool_transverse;
    QTest::newRow("tool_axial") << &LaparoscopeMasses::tool_axial;
    QTest::newRow("end_effector") << &LaparoscopeMasses::end_effector;
    QTest::newRow("end_effector_spin") << &LaparoscopeMasses::end_effector_spin;
    QTest::newRow("pin") << &LaparoscopeMasses::pin;
    QTest::newRow("ring") << &LaparoscopeMasses::ring;
  }
  void a_mass_that_differs_is_noticed() {
    using Mass = double LaparoscopeMasses::*;
    QFETCH(Mass, mass);
    Device other;
    other.masses.*mass *= 1.05;
    const Figures f = compare(other, {}, 10);
    qInfo("5 %% more: holding effort %.1e, acceleration %.1e", f.holding, f.acceleration);
    QVERIFY(f.holding > 1e-6 || f.acceleration > 1e-5);
  }

  void a_length_that_differs_is_noticed_data() {
    QTest::addColumn<double LaparoscopeGeometry::*>("length");
    QTest::newRow("tool_length") << &LaparoscopeGeometry::tool_length;
    QTest::newRow("ring_plane") << &LaparoscopeGeometry::ring_plane;
    QTest::newRow("ring_radius") << &LaparoscopeGeometry::ring_radius;
    QTest::newRow("base_radius") << &LaparoscopeGeometry::base_radius;
    QTest::newRow("platform_radius") << &LaparoscopeGeometry::platform_radius;
    QTest::newRow("link_length") << &LaparoscopeGeometry::link_length;
  }
  void a_length_that_differs_is_noticed() {
    using Length = double LaparoscopeGeometry::*;
    QFETCH(Length, length);
    Device other;
    other.geometry.*length += 10e-9;
    const Figures f = compare(other, {}, 10);
    qInfo("10 nm more: A, B, E %.1e m", f.place);
    QVERIFY(f.place > 1e-9);
  }
};

QTEST_APPLESS_MAIN(TestMujocoOracle)
#include "tst_mujoco_oracle.moc"
