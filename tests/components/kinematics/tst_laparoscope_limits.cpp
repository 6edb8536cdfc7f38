// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_limits.hpp"

#include <QTest>
#include <numbers>

#include "components/kinematics/three_phases.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

constexpr double degree = std::numbers::pi / 180.0;
const LaparoscopeModel model;
const LaparoscopeLimits limits;

/// All limits wide open but for the device's own geometry.
LaparoscopeLimits wide() {
  return {.slider_low = -1.0,
          .slider_high = 1.0,
          .ring_travel = 100.0,
          .centre_offset = 0.089,
          .tilt = 1.5,
          .engagement_low = 0.001,
          .engagement_high = 0.150,
          .link_angle = 1.5};
}

QStringList names(const LimitSet& set) {
  QStringList list;
  for (unsigned i = 0; i < LimitSet::count; ++i)
    if (set.has(i)) list << LimitSet::name(i);
  return list;
}

QString violated(const LaparoscopeLimits& l, const Vector6d& q) {
  LaparoscopeConfiguration c;
  const AssemblyStatus status = model.forward(q, c);
  return status == AssemblyStatus::ok ? names(violated_limits(l, c)).join(' ') : describe(status);
}

Vector6d actuators(const PoseCoordinates& pose) {
  Vector6d q;
  const auto status = model.inverse(pose, q);
  return status == AssemblyStatus::ok ? q : Vector6d::Constant(std::nan(""));
}

Vector6d raised(int axis, double value) {
  Vector6d q;
  q << -.25, -.25, -.25, phase_angle[0], phase_angle[1], phase_angle[2];
  q[axis] = value;
  return q;
}

}  // namespace

class TestLaparoscopeLimits : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void each_slider_is_named_at_both_ends() {
    LaparoscopeLimits narrow = wide();
    narrow.slider_low = -.27;
    narrow.slider_high = -.23;
    for (int i = 0; i < 3; ++i) {
      const QString name = QString("slider_%1").arg(i + 1);
      QCOMPARE(violated(narrow, raised(i, -.27)), QString());
      QCOMPARE(violated(narrow, raised(i, -.27 - 1e-8)), name + "_low");
      QCOMPARE(violated(narrow, raised(i, -.23)), QString());
      QCOMPARE(violated(narrow, raised(i, -.23 + 1e-8)), name + "_high");
    }
  }

  void each_ring_is_named_at_both_ends() {
    LaparoscopeLimits narrow = wide();
    narrow.ring_travel = .3;
    for (int i = 0; i < 3; ++i) {
      const QString name = QString("ring_%1").arg(i + 1);
      QCOMPARE(violated(narrow, raised(3 + i, phase_angle[i] - .3)), QString());
      QCOMPARE(violated(narrow, raised(3 + i, phase_angle[i] - .3 - 1e-8)), name + "_low");
      QCOMPARE(violated(narrow, raised(3 + i, phase_angle[i] + .3)), QString());
      QCOMPARE(violated(narrow, raised(3 + i, phase_angle[i] + .3 + 1e-8)), name + "_high");
    }
  }

  void roll_ends_at_240_degrees() {
    const auto rolled = [](double angle) {
      return violated(limits, actuators({{0, 0, .085}, 0, 0, angle * degree}));
    };
    QCOMPARE(rolled(240.0), QString());
    QCOMPARE(rolled(240.001), QString("ring_1_high ring_2_high ring_3_high"));
    QCOMPARE(rolled(-240.001), QString("ring_1_low ring_2_low ring_3_low"));
  }

  void tilt_is_a_cone_and_not_a_square() {
    LaparoscopeLimits narrow = wide();
    narrow.tilt = 45.0 * degree;
    const auto tilted = [&](double alpha, double beta) {
      return violated(narrow, actuators({{.05, .03, .06}, alpha * degree, beta * degree, 0}));
    };
    QCOMPARE(tilted(44.9, 0), QString());
    QCOMPARE(tilted(45.0, 0), QString());
    QCOMPARE(tilted(45.001, 0), QString("tilt"));
    QCOMPARE(tilted(36.0, 36.0), QString("tilt"));
  }

  void centre_offset_ends_at_60_mm() {
    const auto moved = [](double x, double y) {
      return violated(limits, actuators({{x, y, .085}, 0, 0, 0}));
    };
    QCOMPARE(moved(.0599, 0), QString());
    QCOMPARE(moved(.060, 0), QString());
    QCOMPARE(moved(.0600001, 0), QString("centre_offset"));
    QCOMPARE(moved(-.0425, -.0425), QString("centre_offset"));
  }

  void engagement_is_named_at_both_ends() {
    LaparoscopeLimits narrow = wide();
    narrow.engagement_low = .07;
    narrow.engagement_high = .10;
    const auto at_engagement = [&](double m) {  // tip = zt - M + l
      return violated(narrow, actuators({{0, 0, .17 - m}, 0, 0, 0}));
    };
    QCOMPARE(at_engagement(.07), QString());
    QCOMPARE(at_engagement(.07 - 1e-8), QString("engagement_low"));
    QCOMPARE(at_engagement(.10), QString());
    QCOMPARE(at_engagement(.10 + 1e-8), QString("engagement_high"));
  }

  void on_the_axis_the_engagement_clips_the_last_third_of_a_millimetre() {
    QCOMPARE(violated(limits, actuators({{0, 0, .0251}, 0, 0, 0})), QString());
    QCOMPARE(violated(limits, actuators({{0, 0, .0249}, 0, 0, 0})), QString("engagement_high"));
  }

  void each_link_is_named_data() {
    QTest::addColumn<double>("direction");  // of the platform's offset [deg]
    QTest::addColumn<QString>("name");
    QTest::newRow("away from rail 1") << 180.0 << "link_1_angle";
    QTest::newRow("away from rail 2") << 300.0 << "link_2_angle";
    QTest::newRow("away from rail 3") << 60.0 << "link_3_angle";
  }
  void each_link_is_named() {
    QFETCH(double, direction);
    QFETCH(QString, name);
    LaparoscopeLimits narrow = wide();
    narrow.link_angle = 60.0 * degree;
    const double reach = .210 * std::sin(60.0 * degree) - .100;  // offset at which it is 60 deg
    const auto moved = [&](double offset) {
      const double x = offset * std::cos(direction * degree),
                   y = offset * std::sin(direction * degree);
      Tool::State tool;
      Eigen::Vector3d sliders, rings;
      [[maybe_unused]] auto s = model.tool().forward({x, y, -.05}, {x, y}, 0, {1, 0}, tool);
      s = model.delta().inverse(tool.ball, sliders);
      s = model.rings().inverse(tool.gimbal.head<2>(), 0, rings);
      return violated(narrow, (Vector6d() << sliders, rings).finished());
    };
    QCOMPARE(moved(reach), QString());
    QCOMPARE(moved(reach + 1e-7), name);
  }

  void what_is_not_a_number_violates() {
    LaparoscopeConfiguration c;
    QCOMPARE(model.forward(actuators({{0, 0, .085}, 0, 0, 0}), c), AssemblyStatus::ok);
    c.q[0] = std::nan("");
    QCOMPARE(names(violated_limits(limits, c)), QStringList({"slider_1_low", "slider_1_high"}));
  }

  void reachable_needs_assembly_and_limits() {
    QVERIFY(reachable(model, limits, {{0, 0, .085}, 0, 0, 0}));
    QVERIFY(!reachable(model, limits, {{0, 0, .16}, 0, 0, 0}));
    QVERIFY(!reachable(model, limits, {{.3, 0, .085}, 0, 0, 0}));
    QVERIFY(!reachable(model, limits, {{0, 0, .085}, 1.6, 0, 0}));
  }

  void reference_poses_of_the_default_geometry_are_inside_all_limits() {
    const CsvTable table(std::string(TROCAR_SOURCE_DIR) + "/tests/data/laparoscope/vectors.csv");
    int inside = 0, rows = 0;
    for (const auto& row : table.rows()) {
      if (row.text("set") != "default") continue;
      ++rows;
      inside += violated(limits, actuators_of(row)).isEmpty();
    }
    QVERIFY(rows > 0);
    QCOMPARE(inside, rows);
  }
};

QTEST_APPLESS_MAIN(TestLaparoscopeLimits)
#include "tst_laparoscope_limits.moc"
