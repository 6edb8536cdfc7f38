// SPDX-License-Identifier: Apache-2.0
// A tip's motion becomes that of the axes, and that an effort.
#include <QtTest>
#include <cmath>

#include "components/kinematics/laparoscope_dynamics.hpp"
#include "tests/support/graph_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

/// The tip of a tilted tool moves by a chirp along x.
struct FeedForwardBench : GraphBench {
  NodeId reference, inertia;
  LaparoscopeModel model;
  FeedForwardBench() {
    PoseCoordinates pose{{-0.02, 0.01, 0.09}, 0.2, -0.1, 0.4};
    Vector6d q;
    if (model.inverse(pose, q) != AssemblyStatus::ok) throw std::logic_error("no such pose");
    const NodeId device =
        feed({joints_in({"m", "m", "m", "rad", "rad", "rad"}), [q](double, auto v) {
                for (int i = 0; i < 6; ++i) v[static_cast<std::size_t>(i)] = q[i];
              }});
    const NodeId motion =
        add("ChirpMotion",
            {{"amplitude", {"20 mm"}}, {"axis", {"x"}}, {"from", {"1 Hz"}}, {"to", {"2 Hz"}}});
    reference = add("ToolReference");
    inertia = add("InertiaFeedForward");
    connect(device, "value", reference, "position");
    connect(motion, "offset", reference, "offset");
    connect(motion, "velocity", reference, "tip_velocity");
    connect(motion, "acceleration", reference, "tip_acceleration");
    connect(reference, "axes", inertia, "position");
    connect(reference, "axes_velocity", inertia, "velocity");
    connect(reference, "axes_acceleration", inertia, "acceleration");
  }
  Vector6d six(NodeId node, const char* name) {
    Vector6d values;
    for (int i = 0; i < 6; ++i) values[i] = number(node, name, static_cast<std::size_t>(i));
    return values;
  }
  double kinetic_energy() {
    const LaparoscopeDynamics dynamics({}, {});
    LaparoscopeConfiguration c;
    if (model.forward(six(reference, "axes"), c) != AssemblyStatus::ok) return std::nan("");
    const Vector6d speed = six(reference, "axes_velocity");
    return 0.5 * speed.dot(dynamics.inertia(c, model.rates(c)).mass * speed);
  }
};

}  // namespace

class TestFeedForward : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_axes_follow_the_tip_and_their_rates_each_other() {
    FeedForwardBench bench;
    QCOMPARE(bench.wire(), std::string());
    bench.tick(300);
    for (int k = 0; k < 50; ++k) {
      const Vector6d q0 = bench.six(bench.reference, "axes");
      const Vector6d v0 = bench.six(bench.reference, "axes_velocity");
      bench.tick();
      const Vector6d v1 = bench.six(bench.reference, "axes_velocity");
      const Vector6d a1 = bench.six(bench.reference, "axes_acceleration");
      bench.tick();
      const Vector6d q2 = bench.six(bench.reference, "axes");
      const Vector6d v2 = bench.six(bench.reference, "axes_velocity");
      QVERIFY(((q2 - q0) / 2e-3 - v1).norm() < 1e-4 * v1.norm() + 1e-4);
      QVERIFY(((v2 - v0) / 2e-3 - a1).norm() < 1e-3 * a1.norm() + 1e-3);
    }
    LaparoscopeConfiguration c;
    QCOMPARE(bench.model.forward(bench.six(bench.reference, "axes"), c), AssemblyStatus::ok);
    QVERIFY(std::abs(c.tool.tip.y() - 0.01) < 1e-12 && std::abs(c.tool.tip.z() - 0.09) < 1e-12);
    QVERIFY(std::abs(c.tool.pose().alpha - 0.2) < 1e-12);
  }

  /// The power of the effort is what the kinetic energy grows by.
  void its_effort_does_the_work_of_the_motion() {
    FeedForwardBench bench;
    QCOMPARE(bench.wire(), std::string());
    bench.tick(300);
    double largest = 0.0;
    for (int k = 0; k < 200; ++k) {
      const double before = bench.kinetic_energy();
      bench.tick();
      const double power =
          bench.six(bench.inertia, "effort").dot(bench.six(bench.reference, "axes_velocity"));
      bench.tick();
      const double growth = (bench.kinetic_energy() - before) / 2e-3;
      largest = std::max(largest, std::abs(power));
      QVERIFY2(std::abs(growth - power) < 2e-4,
               qPrintable(QString("%1 W, %2 W").arg(growth).arg(power)));
    }
    QVERIFY2(largest > 0.05, qPrintable(QString::number(largest)));
  }

  void a_goal_out_of_reach_is_a_failure() {
    FeedForwardBench bench;
    bench.graph.set({bench.reference, "link_length"}, {"101 mm"}, {"test", 1});
    QCOMPARE(bench.wire(), std::string());
    bench.tick();
    QVERIFY(bench.wired->component(bench.reference)->failure() != nullptr);
  }
};

QTEST_APPLESS_MAIN(TestFeedForward)
#include "tst_feed_forward.moc"
