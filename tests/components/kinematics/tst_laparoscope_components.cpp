// SPDX-License-Identifier: Apache-2.0
#include <QTest>

#include "components/kinematics/gravity_compensation.hpp"
#include "components/kinematics/laparoscope_kinematics.hpp"
#include "components/kinematics/laparoscope_statics.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;
using Eigen::Vector3d;

namespace {

const LaparoscopeModel model;
const PoseCoordinates tilted{{.02, -.03, .09}, .3, -.2, .5};
const Vector6d moving = (Vector6d() << .1, -.2, .3, 1.0, -2.0, .5).finished();

/// An output with a value, as another component would drive an input.
class Driver final : public Component {
 public:
  void step(const Tick&) RT_SAFE override {}
  Output<Joints> position{this, "position", {.unit = laparoscope_position_units}};
  Output<Joints> velocity{this, "velocity", {.unit = laparoscope_velocity_units}};
  Output<Vector3> a{this, "a", {.unit = "N"}};
  Output<Vector3> b{this, "b", {.unit = "N"}};

  void at(const PoseCoordinates& pose) {
    Vector6d q;
    if (model.inverse(pose, q) != AssemblyStatus::ok) qFatal("no such pose");
    position->head<6>() = q;
  }
};

LaparoscopeConfiguration configuration(const Driver& driver) {
  LaparoscopeConfiguration c;
  if (model.forward((*driver.position).head<6>(), c) != AssemblyStatus::ok) qFatal("no pose");
  return c;
}

void set(ParameterBase& parameter, const char* value) {
  const std::string wrong = parameter.set(literal_from_text(value));
  if (!wrong.empty()) qFatal("%s", wrong.c_str());
}

/// Kinematics behind a driver, configured and stepped once.
struct Rig {
  Driver driver;
  LaparoscopeKinematics tool;

  explicit Rig(const PoseCoordinates& pose = tilted) {
    driver.at(pose);
    driver.velocity->head<6>() = moving;
    tool.position.connect({&driver.position});
    tool.velocity.connect({&driver.velocity});
  }
  void run() {
    tool.configure({});
    tool.step({});
  }
};

}  // namespace

class TestLaparoscopeComponents : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void kinematics_tell_what_the_model_tells() {
    for (const PoseCoordinates& pose : random_reachable_poses(50)) {
      Rig rig(pose);
      rig.run();
      const auto c = configuration(rig.driver);
      const Matrix6d j = model.rates(c).jacobian;
      QVERIFY(rig.tool.failure() == nullptr);
      QVERIFY(rig.tool.jacobian->head<6>() == j);
      QVERIFY(rig.tool.twist->eigen().isApprox(j * moving, 1e-14));
      QVERIFY((rig.tool.pose->position.eigen() - pose.tip).norm() < 1e-12);
      QVERIFY((rig.tool.pose->rotation.eigen().toRotationMatrix() - c.tool.rotation).norm() <
              1e-14);
      QVERIFY((rig.tool.angles->eigen() - Vector3d(pose.alpha, pose.beta, pose.theta)).norm() <
              1e-12);
    }
  }

  void sites_lie_along_the_tool_and_move_as_its_points() {
    Rig rig;
    set(rig.tool.sites.handle_offset, "-150 mm");
    set(rig.tool.sites.incision_offset, "-60 mm");
    rig.run();
    const auto c = configuration(rig.driver);
    QVERIFY((rig.tool.tip->position.eigen() - c.tool.tip).norm() == 0.0);
    QVERIFY((rig.tool.handle->position.eigen() - c.tool.ball).norm() < 1e-15);
    QVERIFY((rig.tool.incision->position.eigen() - (c.tool.tip - .06 * c.tool.axis)).norm() <
            1e-15);
    // A moves with the delta alone.
    const Vector3d ball = model.rates(c).delta.jacobian * moving.head<3>();
    QVERIFY((rig.tool.handle->velocity.eigen() - ball).norm() < 1e-14);
  }

  void without_velocity_nothing_moves() {
    Driver driver;
    driver.at(tilted);
    LaparoscopeKinematics tool;
    tool.position.connect({&driver.position});
    tool.configure({});
    tool.step({});
    QVERIFY(tool.twist->eigen().isZero(0.0) && tool.tip->velocity.eigen().isZero(0.0));
  }

  void quality_follows_from_the_axes_and_the_neutral_jacobian() {
    Rig rig;
    rig.driver.position.quality = {.001, {2e-6, 2e-6, 2e-6, 1e-4, 1e-4, 1e-4}};
    rig.driver.velocity.quality = {.004, {5e-4, 5e-4, 5e-4, 2e-2, 2e-2, 2e-2}};
    rig.run();
    const auto& tip = rig.tool.tip.quality;
    QCOMPARE(tip.delay, .004);
    QCOMPARE(rig.tool.pose.quality.delay, .001);
    // mathematics: rows of J at the neutral pose
    const double x = (.9414 + 2 * .4707) * 2e-6 + 2 * .0917 * 1e-4;
    const double z_speed = 5e-4;
    QVERIFY(std::abs(tip.resolution.at(0) - x) < 2e-3 * x);
    QVERIFY(std::abs(tip.resolution.at(5) - z_speed) < 1e-12);
    const double roll_speed = 2e-2;
    QVERIFY(std::abs(rig.tool.twist.quality.resolution.at(5) - roll_speed) < 1e-12);
  }

  void a_place_that_cannot_be_assembled_is_a_failure() {
    Rig rig;
    rig.tool.configure({});
    rig.driver.position->axis[0] += 1.0;
    rig.tool.step({});
    QVERIFY(rig.tool.failure() != nullptr);
    GravityCompensation weight;
    weight.position.connect({&rig.driver.position});
    weight.configure({});
    weight.step({});
    QVERIFY(weight.failure() != nullptr);
  }

  void a_geometry_that_cannot_be_built_is_refused() {
    Rig rig;
    set(rig.tool.geometry.link_length, "90 mm");
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, rig.tool.configure({}));
  }

  void statics_shift_every_force_to_the_tip_and_keep_its_power() {
    Rig rig;
    set(rig.tool.sites.handle_offset, "-150 mm");
    set(rig.tool.sites.tip_offset, "20 mm");
    rig.run();
    LaparoscopeStatics statics;
    statics.jacobian.connect({&rig.tool.jacobian});
    statics.origin.connect({&rig.tool.pose});
    statics.tip_at.connect({&rig.tool.tip});
    statics.incision_at.connect({&rig.tool.incision});
    statics.handle_at.connect({&rig.tool.handle});
    *rig.driver.a = Vector3(3, -5, 8);
    *rig.driver.b = Vector3(.4, 2, -1);
    statics.handle_force.connect({&rig.driver.a});
    statics.tip_force.connect({&rig.driver.a});
    statics.tip_force.connect({&rig.driver.b});
    statics.incision_moment.connect({&rig.driver.b});
    statics.configure({});
    statics.step({});
    const Vector3d a = rig.driver.a->eigen(), b = rig.driver.b->eigen();
    QVERIFY((statics.wrench->force.eigen() - (2 * a + b)).norm() < 1e-14);
    const double power = a.dot(rig.tool.handle->velocity.eigen()) +
                         (a + b).dot(rig.tool.tip->velocity.eigen()) +
                         b.dot(rig.tool.twist->angular.eigen());
    QVERIFY(std::abs(statics.effort->head<6>().dot(moving) - power) < 1e-13);
    QVERIFY(std::abs(power) > 0.1);
  }

  void gravity_compensation_holds_the_weight_under_any_mount_data() {
    QTest::addColumn<QString>("mount");
    QTest::addColumn<double>("x");  // g in N [m/s^2]
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    const double g = 9.80665, c = g * std::cos(M_PI / 9), s = g * std::sin(M_PI / 9);
    QTest::newRow("upright") << "roll = 0, pitch = 0, yaw = 0" << 0.0 << 0.0 << -g;
    QTest::newRow("turned about the vertical: no difference")
        << "roll = 0, pitch = 0, yaw = 50 deg" << 0.0 << 0.0 << -g;
    QTest::newRow("pitched by 20 degrees") << "pitch = 20 deg" << s << 0.0 << -c;
    QTest::newRow("upside down") << "roll = 180 deg" << 0.0 << 0.0 << g;
  }
  void gravity_compensation_holds_the_weight_under_any_mount() {
    QFETCH(QString, mount);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    Driver driver;
    driver.at(tilted);
    GravityCompensation weight;
    set(weight.mount.mount, qPrintable(mount));
    weight.position.connect({&driver.position});
    weight.configure({});
    weight.step({});
    const auto c = configuration(driver);
    const Vector6d expected =
        LaparoscopeGravity({}, {}).effort(c, model.rates(c), Vector3d(x, y, z));
    QVERIFY((weight.effort->head<6>() - expected).norm() < 1e-12);
    QVERIFY(expected.norm() > 1.0);
  }

  void parameters_have_the_models_defaults() {
    const LaparoscopeKinematics tool;
    const GravityCompensation weight;
    const LaparoscopeGeometry g = tool.geometry.value(), known;
    const LaparoscopeMasses m = weight.masses.value(), known_masses;
    QCOMPARE(g.tool_length, known.tool_length);
    QCOMPARE(g.ring_plane, known.ring_plane);
    QCOMPARE(g.ring_radius, known.ring_radius);
    QCOMPARE(g.base_radius, known.base_radius);
    QCOMPARE(g.platform_radius, known.platform_radius);
    QCOMPARE(g.link_length, known.link_length);
    QVERIFY(g.roll == known.roll);
    QCOMPARE(m.slider, known_masses.slider);
    QCOMPARE(m.link_pair, known_masses.link_pair);
    QCOMPARE(m.platform, known_masses.platform);
    QCOMPARE(m.tool, known_masses.tool);
    QCOMPARE(m.tool_centre, known_masses.tool_centre);
    QCOMPARE(m.end_effector, known_masses.end_effector);
    QCOMPARE(m.pin, known_masses.pin);
  }

  void steps_do_not_allocate() {
    Rig rig;
    rig.run();
    LaparoscopeStatics statics;
    statics.jacobian.connect({&rig.tool.jacobian});
    statics.tip_force.connect({&rig.driver.a});
    statics.configure({});
    GravityCompensation weight;
    weight.position.connect({&rig.driver.position});
    weight.configure({});
    const int n = allocations_in([&] {
      for (int i = 0; i < 100; ++i) {
        rig.tool.step({});
        statics.step({});
        weight.step({});
      }
    });
    QCOMPARE(n, 0);
  }
};

QTEST_APPLESS_MAIN(TestLaparoscopeComponents)
#include "tst_laparoscope_components.moc"
