// SPDX-License-Identifier: Apache-2.0
#include <QTest>
#include <cmath>
#include <numbers>

#include "components/sources/chirp.hpp"
#include "components/sources/sine.hpp"
#include "tests/support/graph_bench.hpp"

using namespace trocar;
using namespace trocar::test;

class TestWaveforms : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sine_has_amplitude_frequency_phase_and_offset() {
    GraphBench bench;
    const NodeId sine = bench.add("Sine", {{"amplitude", {"3 mm"}},
                                           {"frequency", {"0.25 Hz"}},
                                           {"phase", {"90 deg"}},
                                           {"offset", {"1 mm"}}});
    QCOMPARE(bench.wire(), std::string());
    QVERIFY(std::abs(bench.number(sine, "value") - 4e-3) < 1e-15);  // before the first tick
    bench.tick(2001);
    QVERIFY(std::abs(bench.number(sine, "value") - -2e-3) < 1e-15);
    QCOMPARE(bench.output(sine, "value").signature()->text(), std::string("double [m]"));
  }

  void refused_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<QString>("settings");  // "name=value; …"
    QTest::addColumn<QString>("says");
    QTest::newRow("an offset in another unit") << "Sine"
                                               << "amplitude=3 mm;offset=1 N"
                                               << "needs m, as amplitude";
    QTest::newRow("an offset without a unit") << "Sine"
                                              << "amplitude=3 mm;offset=1"
                                              << "needs m, as amplitude";
    QTest::newRow("values of a step in two units") << "Step"
                                                   << "from=1 N;to=3 mm"
                                                   << "needs m";
    QTest::newRow("a chirp's tapers that overlap") << "Chirp"
                                                   << "amplitude=3 mm;duration=2 s;taper=1.1 s"
                                                   << "at most half the duration, 1 s";
  }
  void refused() {
    QFETCH(QString, type);
    QFETCH(QString, settings);
    QFETCH(QString, says);
    GraphBench bench;
    const NodeId source = bench.add(type.toStdString());
    for (const QString& setting : settings.split(';'))
      bench.graph.set({source, setting.section('=', 0, 0).toStdString()},
                      literal_from_text(setting.section('=', 1).toStdString()), {"test", 1});
    const std::string report = bench.wire();
    QVERIFY2(QString::fromStdString(report).contains(says), report.c_str());
  }

  void a_wiring_to_another_unit_is_refused_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<QString>("parameter");
    QTest::newRow("Sine") << "Sine"
                          << "amplitude";
    QTest::newRow("Step") << "Step"
                          << "to";
    QTest::newRow("Chirp") << "Chirp"
                           << "amplitude";
  }
  void a_wiring_to_another_unit_is_refused() {
    QFETCH(QString, type);
    QFETCH(QString, parameter);
    for (const bool right : {true, false}) {
      GraphBench bench;
      const NodeId point = bench.feed({vector_in("m"), [](double, auto) {}});
      const NodeId speed = bench.feed({vector_in("m/s"), [](double, auto) {}});
      const NodeId wall = bench.add("Wall");
      bench.connect(point, "value", wall, "position");
      bench.connect(speed, "value", wall, "velocity");
      const NodeId source = bench.add(
          type.toStdString(), {{parameter.toStdString(), {std::string(right ? "3 mm" : "3 N")}}});
      bench.connect(source, "value", wall, "offset");
      const std::string report = bench.wire();
      QCOMPARE(report.empty(), right);
      if (!right) QVERIFY2(report.find("[N] cannot go where [m]") != report.npos, report.c_str());
    }
  }

  void step_changes_at_its_tick() {
    GraphBench bench;
    const NodeId step = bench.add("Step", {{"from", {"1 N"}}, {"to", {"5 N"}}, {"at", {"3 ms"}}});
    QCOMPARE(bench.wire(), std::string());
    for (int tick = 0; tick < 6; ++tick) {
      bench.tick();
      QCOMPARE(bench.number(step, "value"), tick < 3 ? 1.0 : 5.0);
    }
  }

  void step_down_to_a_bare_zero_keeps_its_unit() {
    GraphBench bench;
    const NodeId step = bench.add("Step", {{"from", {"1 N"}}, {"to", {0.0}}});
    QCOMPARE(bench.wire(), std::string());
    QCOMPARE(bench.output(step, "value").signature()->text(), std::string("double [N]"));
  }

  void chirp_phase_is_the_integral_of_its_frequency() {
    const LinearSweep sweep{.amplitude = 2.0, .from = 0.5, .to = 4.0, .duration = 8.0};
    constexpr int steps = 80000;
    const double h = sweep.duration / steps;
    double phase = 0.0;  // Simpson's rule, exact for a straight line
    double worst = 0.0;
    for (int i = 0; i < steps - 1; ++i) {
      const double t = i * h;
      worst = std::max(worst, std::abs(sweep.at(t) - 2.0 * std::sin(phase)));
      phase += 2.0 * std::numbers::pi * h / 6.0 *
               (sweep.frequency(t) + 4.0 * sweep.frequency(t + h / 2) + sweep.frequency(t + h));
    }
    QVERIFY2(worst < 1e-8, qPrintable(QString::number(worst)));
  }

  void chirp_tapers_and_ends() {
    const LinearSweep whole{.amplitude = 1.0, .from = 1.0, .to = 2.0, .duration = 4.0};
    LinearSweep tapered = whole;
    tapered.taper = 1.0;
    QVERIFY(std::abs(tapered.at(0.3) -
                     0.5 * (1 - std::cos(0.3 * std::numbers::pi)) * whole.at(0.3)) < 1e-12);
    QVERIFY(std::abs(tapered.at(3.7) -
                     0.5 * (1 - std::cos(0.3 * std::numbers::pi)) * whole.at(3.7)) < 1e-12);
    QCOMPARE(tapered.at(2.3), whole.at(2.3));
    QCOMPARE(tapered.at(4.0), 0.0);
    QCOMPARE(tapered.at(9.0), 0.0);
    QCOMPARE(tapered.frequency(9.0), 0.0);
    QCOMPARE(tapered.frequency(2.0), 1.5);
  }

  void chirp_publishes_its_frequency() {
    GraphBench bench;
    const NodeId chirp = bench.add("Chirp", {{"amplitude", {"20 mm"}}, {"duration", {"9 s"}}});
    QCOMPARE(bench.wire(), std::string());
    bench.tick(4501);
    QVERIFY(std::abs(bench.number(chirp, "frequency") - 0.55) < 1e-12);
  }
};

QTEST_APPLESS_MAIN(TestWaveforms)
#include "tst_waveforms.moc"
