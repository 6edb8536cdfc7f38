// SPDX-License-Identifier: Apache-2.0
#include "components/sources/tool_motion.hpp"

#include <QtTest>
#include <cmath>

#include "tests/support/graph_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

/// Whether velocity and acceleration are the differences of offset and velocity at t.
template <typename Motion>
bool consistent(const Motion& motion, double t) {
  constexpr double h = 1e-5;
  const MotionPoint before = motion(t - h), now = motion(t), after = motion(t + h);
  return std::abs((after.offset - before.offset) / (2 * h) - now.velocity) < 1e-7 &&
         std::abs((after.velocity - before.velocity) / (2 * h) - now.acceleration) < 1e-6;
}

}  // namespace

class TestToolMotion : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_chirps_derivatives_are_exact() {
    const LinearSweep sweep{
        .amplitude = 0.04, .from = 0.1, .to = 1.0, .duration = 10.0, .taper = 2.0};
    for (const double t : {0.3, 1.0, 1.9, 3.3, 7.0, 8.5, 9.9}) {
      QCOMPARE(sweep_motion(sweep, t).offset, sweep.at(t));
      QVERIFY2(consistent([&](double s) { return sweep_motion(sweep, s); }, t),
               qPrintable(QString::number(t)));
    }
    QCOMPARE(sweep_motion(sweep, -0.1).velocity, 0.0);
    QCOMPARE(sweep_motion(sweep, 10.0).acceleration, 0.0);
  }

  /// v = 0.1 m/s, a = 2 m/s²: run-up 50 ms over 2.5 mm, a way 0.4 s, a turn 0.1 s.
  void a_shuttle_goes_to_and_fro_at_its_speed() {
    const Shuttle shuttle{.stroke = 0.04, .speed = 0.1, .acceleration = 2.0};
    QVERIFY(std::abs(shuttle.at(0.05).offset - 2.5e-3) < 1e-12);
    QVERIFY(std::abs(shuttle.at(0.45).offset - 42.5e-3) < 1e-12);
    QVERIFY(std::abs(shuttle.at(0.50).offset - 45e-3) < 1e-12);  // the far end
    QVERIFY(std::abs(shuttle.at(0.95).offset - 2.5e-3) < 1e-12);
    QVERIFY(std::abs(shuttle.at(1.00).offset) < 1e-12);  // the near end
    QVERIFY(shuttle.at(0.25).steady && shuttle.at(0.25).velocity == 0.1);
    QVERIFY(shuttle.at(0.75).steady && shuttle.at(0.75).velocity == -0.1);
    QVERIFY(!shuttle.at(0.03).steady && !shuttle.at(0.5).steady && !shuttle.at(1.0).steady);
    for (const double t : {0.02, 0.2, 0.47, 0.53, 0.7, 0.97, 1.02, 1.2, 5.33})
      QVERIFY2(consistent([&](double s) { return shuttle.at(s); }, t),
               qPrintable(QString::number(t)));
  }

  void it_begins_when_it_is_told_and_leads_by_what_it_is_told() {
    const GraphBench::Settings settings = {{"amplitude", {"10 mm"}},
                                           {"from", {"1 Hz"}},
                                           {"to", {"1 Hz"}},
                                           {"axis", {"y"}},
                                           {"begin", {"1 s"}}};
    GraphBench bench;
    const NodeId plain = bench.add("ChirpMotion", settings, "plain");
    GraphBench::Settings early = settings;
    early.push_back({"lead", {"0.1 s"}});
    const NodeId ahead = bench.add("ChirpMotion", early, "ahead");
    QCOMPARE(bench.wire(), std::string());
    bench.tick(901);
    QCOMPARE(bench.number(plain, "offset", 1), 0.0);
    bench.tick(350);  // t = 1.25 s
    QVERIFY(std::abs(bench.number(plain, "offset", 1) - 10e-3) < 1e-12);
    QVERIFY(std::abs(bench.number(ahead, "offset", 1) - 10e-3 * std::sin(0.7 * M_PI)) < 1e-12);
    QCOMPARE(bench.number(plain, "offset", 0), 0.0);
  }

  void tapers_that_overlap_are_refused() {
    GraphBench bench;
    bench.add("ChirpMotion",
              {{"amplitude", {"10 mm"}}, {"duration", {"2 s"}}, {"taper", {"1.1 s"}}});
    const std::string report = bench.wire();
    QVERIFY2(report.find("at most half the duration") != std::string::npos, report.c_str());
  }
};

QTEST_APPLESS_MAIN(TestToolMotion)
#include "tst_tool_motion.moc"
