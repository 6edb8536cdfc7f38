// SPDX-License-Identifier: Apache-2.0
// Friction compensation and gain calibration.
#include <QtTest>
#include <cmath>

#include "components/control/friction_compensation.hpp"
#include "components/control/gain_calibration.hpp"
#include "tests/support/graph_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

Signature positions() {
  return joints_in({"m", "m", "m", "rad", "rad", "rad"});
}
Signature velocities() {
  return joints_in({"m/s", "m/s", "m/s", "rad/s", "rad/s", "rad/s"});
}
Signature efforts() {
  return joints_in({"N", "N", "N", "N m", "N m", "N m"});
}

}  // namespace

class TestCompensation : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_bristle_bends_over_its_length_and_drags_behind() {
    DraggedBristle bristle{.length = 1e-3};
    bristle.reset(0.1);
    QCOMPARE(bristle.drag(0.1), 0.0);
    QVERIFY(std::abs(bristle.drag(0.1005) - 0.5) < 1e-9);
    QVERIFY(std::abs(bristle.drag(0.105) - 1.0) < 1e-9);
    QVERIFY(std::abs(bristle.drag(0.104) - 0.0) < 1e-9);
    QVERIFY(std::abs(bristle.drag(0.101) + 1.0) < 1e-9);
  }

  /// Back and forth by less than the bristle bends, it gives back all that it took.
  void its_work_is_at_most_the_frictions() {
    DraggedBristle bristle{.length = 20e-6};
    bristle.reset(0.0);
    double q = 0.0, work = 0.0, way = 0.0;
    for (int k = 1; k <= 20000; ++k) {
      const double next = 1e-3 * std::sin(3e-3 * k) + 15e-6 * std::sin(0.9 * k);
      const double before = bristle.drag(q);
      work += 0.5 * (before + bristle.drag(next)) * (next - q);
      way += std::abs(next - q);
      q = next;
    }
    QVERIFY(work > 0.0);
    QVERIFY2(work <= way, qPrintable(QString("%1 of %2").arg(work).arg(way)));
  }

  void it_takes_off_a_share_of_dry_and_viscous_friction() {
    GraphBench bench;
    const NodeId position = bench.feed({positions(), [](double t, auto q) {
                                          q[0] = 10e-3 * t;
                                          q[4] = -0.2 * t;
                                        }});
    const NodeId velocity = bench.feed({velocities(), [](double, auto v) {
                                          v[0] = 10e-3;
                                          v[4] = -0.2;
                                        }});
    const NodeId friction = bench.add(
        "FrictionCompensation", {{"share", {0.5}},
                                 {"slider_dry", literal_from_text("0.4 N, 0.4 N, 0.4 N")},
                                 {"ring_dry", literal_from_text("0.01 N m, 0.02 N m, 0.01 N m")},
                                 {"slider_viscous", literal_from_text("8 N s/m, 8 N s/m, 8 N s/m")},
                                 {"ring_viscous", literal_from_text("0, 0.06 N m s/rad, 0")}});
    bench.connect(position, "value", friction, "position");
    bench.connect(velocity, "value", friction, "velocity");
    QCOMPARE(bench.wire(), std::string());
    bench.tick(1);
    QVERIFY(std::abs(bench.number(friction, "effort", 0) - 0.5 * 0.08) < 1e-12);
    bench.tick(100);
    QVERIFY(std::abs(bench.number(friction, "effort", 0) - 0.5 * (0.4 + 0.08)) < 1e-12);
    QVERIFY(std::abs(bench.number(friction, "effort", 4) + 0.5 * (0.02 + 0.012)) < 1e-12);
    QCOMPARE(bench.number(friction, "effort", 1), 0.0);
  }

  void it_does_not_chatter_at_rest() {
    GraphBench bench;
    const NodeId position =
        bench.feed({positions(), [](double t, auto q) { q[0] = std::min(10e-3 * t, 1e-3); }});
    const NodeId friction = bench.add("FrictionCompensation",
                                      {{"slider_dry", literal_from_text("0.4 N, 0.4 N, 0.4 N")}});
    bench.connect(position, "value", friction, "position");
    QCOMPARE(bench.wire(), std::string());
    bench.tick(200);
    const double resting = bench.number(friction, "effort", 0);
    QVERIFY(std::abs(resting - 0.36) < 1e-12);
    for (int k = 0; k < 100; ++k) {
      bench.tick();
      QCOMPARE(bench.number(friction, "effort", 0), resting);
    }
  }

  void a_drive_that_gives_less_is_asked_for_more() {
    GraphBench bench;
    const NodeId wanted = bench.feed({efforts(), [](double, auto u) {
                                        u[0] = 9.6;
                                        u[5] = 1.0;
                                      }});
    const NodeId drives =
        bench.add("GainCalibration", {{"gain", literal_from_text("0.96, 1, 1, 1, 1, 0.8")}});
    bench.connect(wanted, "value", drives, "wanted");
    QCOMPARE(bench.wire(), std::string());
    bench.tick();
    QVERIFY(std::abs(bench.number(drives, "effort", 0) - 10.0) < 1e-12);
    QVERIFY(std::abs(bench.number(drives, "effort", 5) - 1.25) < 1e-12);
  }

  void gains_that_cannot_be_are_refused() {
    for (const char* gains : {"1, 1, 1, 1, 1, 0.1", "0, 1, 1, 1, 1, 1"}) {
      GraphBench bench;
      const NodeId wanted = bench.feed({efforts(), [](double, auto) {}});
      const NodeId drives = bench.add("GainCalibration", {{"gain", literal_from_text(gains)}});
      bench.connect(wanted, "value", drives, "wanted");
      const std::string report = bench.wire();
      QVERIFY2(report.find("needs 0.5 to 2 for each of the six axes") != std::string::npos,
               report.c_str());
    }
  }
};

QTEST_APPLESS_MAIN(TestCompensation)
#include "tst_compensation.moc"
