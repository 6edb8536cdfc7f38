// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope.hpp"

// Before Qt, whose macros take words that the framework uses.
#include "tests/support/laparoscope_rig.hpp"

#include <QTest>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/laparoscope_poses.hpp"
#include "tests/support/sanitized.hpp"

using namespace trocar;
using namespace trocar::test;
using Eigen::Vector3d;

namespace {

/// 27 poses inside the workspace: the tip on a grid, the tool tilted and turned.
std::vector<PoseCoordinates> poses_on_a_grid() {
  std::vector<PoseCoordinates> poses;
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      for (const double z : {-1.0, 0.0, 1.0})
        poses.push_back({{.03 * x, .03 * y, .085 + .015 * z}, .25 * x + .05 * z, .15 * y, .6 * z});
  return poses;
}

std::string text(const Vector3d& v, const char* unit) {
  std::string list;
  for (const double x : v)
    list += (list.empty() ? "" : ", ") + QByteArray::number(x, 'g', 17).toStdString() + " " + unit;
  return list;
}

Settings at(const PoseCoordinates& pose) {
  return {{"laparoscope.device.start_position", text(pose.tip, "m")},
          {"laparoscope.device.start_angles", text({pose.alpha, pose.beta, pose.theta}, "rad")}};
}

}  // namespace

class TestLaparoscope : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_group_wires_without_a_finding() {
    LaparoscopeRig rig;
    const Findings findings = check(rig.graph, {});
    QVERIFY2(findings.empty(), findings.text().c_str());
    QCOMPARE(rig.graph.node(rig.group).exports.sites.size(), std::size_t(3));
  }

  void held_by_feed_forward_it_does_not_drift_data() {
    QTest::addColumn<QString>("mount");
    QTest::newRow("upright") << "pitch = 0";
    QTest::newRow("tilted by 20 degrees") << "pitch = 20 deg";
  }
  void held_by_feed_forward_it_does_not_drift() {
    QFETCH(QString, mount);
    double worst = 0.0;
    for (const PoseCoordinates& pose : poses_on_a_grid()) {
      Settings settings = at(pose);
      settings.push_back({"laparoscope.ideal", "true"});
      settings.push_back({"laparoscope.mount", mount.toStdString()});
      LaparoscopeRig rig(settings);
      rig.start();
      const Vector3d before = rig.device->truth.tip->position.eigen();
      QVERIFY((before - pose.tip).norm() < 1e-12);
      rig.run(sanitized ? 101 : 1001);
      worst = std::max(worst, (rig.device->truth.tip->position.eigen() - before).norm());
      QVERIFY(!rig.executor->faults().latched());
    }
    qInfo("largest drift: %.3g m", worst);
    QVERIFY(worst <= 1e-6);
  }

  void without_hold_it_falls() {
    LaparoscopeRig rig(Settings{{"laparoscope.ideal", "true"},
                                {"laparoscope.weight.tool_mass", "0 g"},
                                {"laparoscope.weight.slider_mass", "0 g"}});
    rig.start();
    rig.run(100);
    QVERIFY(rig.device->truth.tip->position.z < .085 - 1e-3);
  }

  void with_friction_it_rests_to_the_bit_data() {
    QTest::addColumn<QString>("mount");
    QTest::newRow("upright") << "pitch = 0";
    QTest::newRow("tilted by 20 degrees") << "pitch = 20 deg";
  }
  void with_friction_it_rests_to_the_bit() {
    QFETCH(QString, mount);
    for (const PoseCoordinates& pose : poses_on_a_grid()) {
      Settings settings = at(pose);
      settings.push_back({"laparoscope.mount", mount.toStdString()});
      LaparoscopeRig rig(settings);
      rig.start();
      const Vector6d motors = rig.device->truth.motor_position->head<6>();
      const Vector6d before = rig.device->truth.position->head<6>();
      const Joints reported = *rig.device->device_position;
      rig.run(500);
      QVERIFY(rig.device->truth.motor_position->head<6>() == motors);
      QVERIFY(rig.device->device_position->head<6>() == reported.head<6>());
      // The mechanism swings on its transmissions by rounding errors.
      QVERIFY((rig.device->truth.position->head<6>() - before).norm() < 1e-12);
      QVERIFY(rig.device->truth.velocity->head<6>().norm() < 1e-10);
    }
  }

  // hand: F = k_h (x_h - z);  wall: F = K (z - surface);  x_h = 85 mm + 60 mm
  void the_wall_stops_the_pushing_hand_where_statics_says_data() {
    QTest::addColumn<QString>("ideal");
    QTest::addColumn<double>("gain");       // of the drives
    QTest::addColumn<double>("tolerance");  // [m]
    QTest::newRow("ideal device") << "true" << 1.0 << 1e-6;
    // Dry friction of 0.35 N in three sliders: 0.43 mm; homing: 0.18 mm; spread of the gains and
    // weights: 0.06 mm.
    QTest::newRow("with friction and errors") << "false" << 0.9655 << 0.7e-3;
  }
  void the_wall_stops_the_pushing_hand_where_statics_says() {
    QFETCH(QString, ideal);
    QFETCH(double, gain);
    QFETCH(double, tolerance);
    LaparoscopeRig rig(Settings{{"laparoscope.hand", "push"},
                                {"laparoscope.ideal", ideal.toStdString()},
                                {"wall.damping", "20 N s/m"}});
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    rig.run(4900);
    constexpr double weight = 11.886;  // [N] along n3, of which the drives hold their share
    const double wall = 2200.0 * gain;
    const double expected = (250.0 * .145 + wall * .105 - (1.0 - gain) * weight) / (250.0 + wall);
    const double rest = rig.device->truth.tip->position.z;
    qInfo("rests at %.4f mm, statics says %.4f mm; hand %.3f N", 1e3 * rest, 1e3 * expected,
          rig.device->truth.hand_force->z);
    QVERIFY(std::abs(rest - expected) < tolerance);
    QVERIFY(rest > .108);
    QVERIFY(rig.device->truth.velocity->head<6>().norm() < 1e-4);
    QVERIFY(!rig.executor->faults().latched());
    QCOMPARE(*rig.device->scale, 1.0);
  }

  void a_hand_that_withdraws_leaves_the_wall() {
    LaparoscopeRig rig(
        Settings{{"laparoscope.hand", "push"}, {"laparoscope.device.push_dwell", "0.5 s"}});
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    rig.run(4100);
    QVERIFY(rig.device->truth.tip->position.z < .090);
  }

  void a_load_pulls_at_its_site_and_never_goes_through_the_motors() {
    LaparoscopeRig rig(Settings{{"laparoscope.hand", "firm"},
                                {"laparoscope.ideal", "true"},
                                {"laparoscope.handle_offset", "-150 mm"},
                                {"weight.pull", "0 N, 0 N, 5 N"}});
    rig.place("TestLoad", "weight", "handle");
    rig.start();
    rig.run(3000);
    // The tool is upright: along its axis the place makes no difference, 5 N against 250 N/m.
    QVERIFY(std::abs(rig.device->truth.tip->position.z - .105) < 1e-5);
    QCOMPARE(*rig.device->scale, 1.0);
    QVERIFY(rig.device->effort_sent->head<6>() == rig.device->hold->head<6>());
  }

  void a_lateral_load_at_the_handle_turns_the_tool_as_its_lever_says() {
    LaparoscopeRig rig(Settings{{"laparoscope.hand", "firm"},
                                {"laparoscope.ideal", "true"},
                                {"laparoscope.handle_offset", "-50 mm"},
                                {"weight.pull", "0.2 N, 0 N, 0 N"}});
    rig.place("TestLoad", "weight", "handle");
    rig.start();
    rig.run(20000);
    // Hand: 250 N/m and 1 N m/rad at E; the moment about E is s t x f.
    const Vector3d t = rig.tool->pose->rotation.eigen() * Vector3d::UnitZ();
    const double angle = std::atan2(t.x(), t.z());
    QVERIFY(std::abs(rig.device->truth.tip->position.x - .2 / 250.0) < 1e-5);
    QVERIFY(std::abs(angle - -.05 * .2 * t.z() / 1.0) < 1e-4);
  }

  void nan_of_a_fixture_never_reaches_the_plant() {
    constexpr std::int64_t broken = 2000;
    LaparoscopeRig rig(Settings{{"laparoscope.hand", "push"},
                                {"wall.constant", "1 N"},
                                {"wall.broken_from", std::to_string(broken)}});
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    rig.run(broken);
    const auto rendered = [&] {
      return Vector6d(rig.device->effort_sent->head<6>() - rig.device->hold->head<6>());
    };
    QVERIFY(rendered().norm() > 0.1);
    for (int i = 0; i < 200; ++i) {
      rig.tick();
      // What is left is damping, which brakes and is capped.
      const Vector6d left = rendered();
      QVERIFY(left.allFinite() && rig.device->effort_applied->head<6>().allFinite());
      QVERIFY(left.head<3>().cwiseAbs().maxCoeff() <= 5.0 + 1e-12);
      QVERIFY(left.tail<3>().cwiseAbs().maxCoeff() <= 0.3 + 1e-12);
      QVERIFY(left.dot(rig.executor->gates().front().velocity().head<6>()) <= 1e-12);
      QVERIFY(rig.device->truth.position->head<6>().allFinite());
    }
    QVERIFY(rig.device->hold->head<3>().norm() > 1.0);
    const Fault& first = rig.executor->faults()[0];
    QVERIFY(first.cause == FaultCause::not_finite);
    QCOMPARE(QByteArray(first.component), QByteArray("wall"));
    QCOMPARE(first.tick, broken);
    QVERIFY(rig.state() == Gate::State::tripped);
  }

  void two_runs_are_alike_to_the_bit() {
    const auto end = [] {
      LaparoscopeRig rig(Settings{{"laparoscope.hand", "push"}});
      rig.place("TestFixture", "wall", "tip");
      rig.start();
      rig.run(1500);
      return Vector6d(rig.device->truth.position->head<6>());
    };
    QVERIFY(end() == end());
  }

  void a_tick_does_not_allocate() {
    LaparoscopeRig rig(Settings{{"laparoscope.hand", "push"}});
    rig.place("TestFixture", "wall", "tip");
    rig.place("TestLoad", "weight", "handle");
    rig.start();
    QCOMPARE(allocations_in([&] { rig.run(2500); }), 0);
  }

  void cost_of_a_tick() {
    LaparoscopeRig rig(Settings{{"laparoscope.hand", "push"}});
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    QBENCHMARK {
      rig.tick();
    }
  }
};

QTEST_APPLESS_MAIN(TestLaparoscope)
#include "tst_laparoscope.moc"
