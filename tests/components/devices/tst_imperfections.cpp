// SPDX-License-Identifier: Apache-2.0
// What each imperfection does to the rendered stiffness: a spring at the incision, known loads up
// and down on both sides, as in Table I of the device's paper.
#include "tests/support/laparoscope_rig.hpp"

#include <QTest>

#include "components/fixtures/spring.hpp"
#include "components/sources/staircase.hpp"
#include "framework/signal_math.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

constexpr double stiffness = 5000.0;  // [N/m]
constexpr double weight = 11.886;     // [N] of what moves along z

/// What was measured where a load had settled.
struct Measured {
  std::vector<double> load, stretch, truth, gain;

  LineFit line() const { return fit_line(stretch, load); }
  /// The largest deviation of the load from what the spring is told to render [N].
  double largest_deviation() const {
    double worst = 0.0;
    for (std::size_t i = 0; i < load.size(); ++i)
      worst = std::max(worst, std::abs(load[i] - stiffness * stretch[i]));
    return worst;
  }
};

Measured measure(const char* axis, Settings settings) {
  for (const auto& [key, value] : Settings{{"spring.axis", "all"},
                                           {"spring.stiffness", "5 N/mm"},
                                           {"spring.damping", "20 N s/m"},
                                           {"staircase.axis", axis},
                                           {"staircase.peak", "18 N"},
                                           {"staircase.ramp", "0.6"},
                                           {"staircase.duration", "12 s"}})
    settings.emplace_back(key, value);
  LaparoscopeRig rig(settings, 4000.0);
  rig.place("Spring", "spring", "incision");
  rig.place("Staircase", "staircase", "incision");
  rig.start();
  const auto& spring = static_cast<const Spring&>(*rig.wired->find("spring"));
  const auto& staircase = static_cast<const Staircase&>(*rig.wired->find("staircase"));
  const int i = axis[0] - 'x';
  const double start = rig.device->truth.tip->position.eigen()[i];
  Measured measured;
  for (int k = 0; k < 48000; ++k) {
    rig.tick();
    if (!*staircase.settled) continue;
    measured.load.push_back(*staircase.load);
    measured.stretch.push_back(spring.displacement->eigen()[i]);
    measured.truth.push_back(rig.device->truth.tip->position.eigen()[i] - start);
    measured.gain.push_back((*rig.device->truth.gain)[0]);
  }
  if (rig.executor->faults().latched()) return {};
  return measured;
}

/// A device that is perfect but for what is switched on. A hand keeps the tool from turning and
/// does nothing else: the spring does not hold it, and without friction nothing would.
Settings only(const std::vector<std::string>& imperfections, const Settings& more = {}) {
  Settings settings = more;
  for (const auto& [name, value] : Settings{{"hand_mass", "0 kg"},
                                            {"hand_stiffness", "0 N/m"},
                                            {"hand_damping", "0 N s/m"},
                                            {"hand_rotational_stiffness", "10 N m/rad"},
                                            {"hand_rotational_damping", "0.2 N m s/rad"}})
    settings.emplace_back("laparoscope.device." + name, value);
  settings.emplace_back("laparoscope.hand", "firm");
  for (const char* name :
       {"friction", "stribeck", "gain_error", "gain_drift", "ripple", "cogging", "quantisation",
        "thermal", "compliance", "homing_error", "weight_error"}) {
    const bool on =
        std::find(imperfections.begin(), imperfections.end(), name) != imperfections.end();
    settings.emplace_back(std::string("laparoscope.device.") + name, on ? "true" : "false");
  }
  return settings;
}

std::pair<std::string, std::string> set(const char* name, const char* value) {
  return {std::string("laparoscope.device.") + name, value};
}

}  // namespace

class TestImperfections : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_perfect_device_renders_what_it_is_told_data() {
    QTest::addColumn<QString>("axis");
    QTest::addColumn<bool>("ideal");
    for (const char* axis : {"x", "y", "z"})
      QTest::addRow("ideal, %s", axis) << QString(axis) << true;
    QTest::newRow("all switched off, x") << "x" << false;
  }
  void a_perfect_device_renders_what_it_is_told() {
    QFETCH(QString, axis);
    QFETCH(bool, ideal);
    const Measured m =
        measure(axis.toUtf8(), ideal ? Settings{{"laparoscope.ideal", "true"}} : only({}));
    QVERIFY(m.load.size() > 10000);
    const LineFit line = m.line();
    qInfo("error %.4f %%, R2 %.7f", 100.0 * (1.0 - line.slope / stiffness), line.r2);
    QVERIFY(std::abs(line.slope / stiffness - 1.0) <= 0.002);
    QVERIFY(line.r2 > 0.99999);
  }

  void what_does_no_work_at_rest_leaves_the_slope_data() {
    QTest::addColumn<QStringList>("settings");
    QTest::newRow("viscous friction")
        << QStringList{"friction=true", "slider_coulomb=0 N", "ring_coulomb=0 N m"};
    QTest::newRow("homing error") << QStringList{"homing_error=true"};
    QTest::newRow("delay of one and a half ticks") << QStringList{"delay=1.5"};
    QTest::newRow("late samples") << QStringList{"report_jitter=0.2 ms"};
    QTest::newRow("lost reports") << QStringList{"report_loss=5 %"};
    QTest::newRow("motors that stay cool") << QStringList{"thermal=true"};
  }
  void what_does_no_work_at_rest_leaves_the_slope() {
    QFETCH(QStringList, settings);
    Settings more = only({});
    for (const QString& one : settings) {
      const std::string key = "laparoscope.device." + one.section('=', 0, 0).toStdString();
      std::erase_if(more, [&](const auto& known) { return known.first == key; });
      more.emplace_back(key, one.section('=', 1).toStdString());
    }
    const LineFit line = measure("x", more).line();
    QVERIFY2(std::abs(line.slope / stiffness - 1.0) <= 0.003,
             QByteArray::number(line.slope / stiffness));
  }

  void the_slope_is_the_drives_gain_times_what_was_asked() {
    const LineFit line =
        measure("x", only({"gain_error"}, {set("drive_gain", "0.94"), set("gain_spread", "0")}))
            .line();
    QVERIFY2(std::abs(line.slope / stiffness / 0.94 - 1.0) <= 0.003,
             QByteArray::number(line.slope / stiffness));
  }

  void warm_drives_render_their_gain_of_the_moment() {
    const Measured m = measure(
        "z", only({"gain_drift"}, {set("gain_loss", "1 %/K"), set("winding_time", "1 s"),
                                   set("magnet_time", "1 s"), set("slider_continuous", "20 N")}));
    QVERIFY(!m.load.empty());
    double worst = 0.0, least = 1.0;
    for (std::size_t i = 0; i < m.load.size(); ++i) {
      // Load and weight against g times what is sent for both.
      const double expected = m.gain[i] * stiffness * m.stretch[i] + (1.0 - m.gain[i]) * weight;
      worst = std::max(worst, std::abs(m.load[i] - expected));
      least = std::min(least, m.gain[i]);
    }
    QVERIFY2(worst < 0.15, QByteArray::number(worst));
    QVERIFY2(least < 0.95, QByteArray::number(least));
  }

  void a_yielding_transmission_shows_at_the_tip_and_not_at_the_encoders() {
    const Measured m = measure("x", only({"compliance"}, {set("slider_stiffness", "800 N/mm"),
                                                          set("ring_stiffness", "10 kN m/rad")}));
    QVERIFY(std::abs(m.line().slope / stiffness - 1.0) <= 0.003);
    const double felt = fit_line(m.truth, m.load).slope;
    const double expected = 1.0 / (1.0 / stiffness + 1.0 / 300e3);  // ten times as soft as usual
    QVERIFY2(std::abs(felt / expected - 1.0) <= 0.003, QByteArray::number(felt / expected));
  }

  void dry_friction_opens_a_loop_of_its_own_height_data() {
    QTest::addColumn<QStringList>("with");
    QTest::addColumn<double>("least");  // [N], half of the loop
    QTest::addColumn<double>("most");
    // Along z all three sliders move alike: 3 x 0.35 N; up to 1.2 times as much at rest.
    QTest::newRow("Coulomb's") << QStringList{"friction"} << 0.9 * 1.05 << 1.02 * 1.05;
    QTest::newRow("Stribeck's") << QStringList{"friction", "stribeck"} << 1.0 * 1.05 << 1.22 * 1.05;
  }
  void dry_friction_opens_a_loop_of_its_own_height() {
    QFETCH(QStringList, with);
    QFETCH(double, least);
    QFETCH(double, most);
    std::vector<std::string> names;
    for (const QString& name : with) names.push_back(name.toStdString());
    const Measured m = measure("z", only(names));
    QVERIFY(!m.load.empty());
    double low = 0.0, high = 0.0;
    for (std::size_t i = 0; i < m.load.size(); ++i) {
      low = std::min(low, m.load[i] - stiffness * m.stretch[i]);
      high = std::max(high, m.load[i] - stiffness * m.stretch[i]);
    }
    const double half = 0.5 * (high - low);
    QVERIFY2(half >= least && half <= most, QByteArray::number(half));
  }

  void a_wrong_weight_shifts_the_line_by_the_difference() {
    const LineFit line = measure("z", only({"weight_error"})).line();
    // tool 120 g / 0.95, sliders 320 g / 1.01, of which the drives hold the nominal weight
    const double more = 9.80665 * (0.120 / 0.95 - 0.120 + 3 * (0.320 / 1.01 - 0.320));
    QVERIFY2(std::abs(line.offset - more) < 2e-3, QByteArray::number(line.offset - more));
    QVERIFY(std::abs(line.slope / stiffness - 1.0) <= 0.003);
  }

  void deviations_are_bounded_by_their_amplitudes_data() {
    QTest::addColumn<QString>("imperfection");
    QTest::addColumn<double>("least");  // [N] of the largest deviation
    QTest::addColumn<double>("most");
    QTest::newRow("ripple: 0.7 % of load and weight") << "ripple" << 0.05 << 0.007 * (18 + weight);
    QTest::newRow("cogging of three sliders") << "cogging" << 0.03 << 3 * 0.05 + 5e-3;
    // Half a step of three amplifiers, and a count of the encoders.
    QTest::newRow("quantisation") << "quantisation" << 1e-3
                                  << 3 * 0.5 * 200.0 / 8192 + stiffness * 2e-6;
  }
  void deviations_are_bounded_by_their_amplitudes() {
    QFETCH(QString, imperfection);
    QFETCH(double, least);
    QFETCH(double, most);
    const Measured m = measure("z", only({imperfection.toStdString()}));
    QVERIFY(!m.load.empty());
    const double deviation = m.largest_deviation();
    QVERIFY2(deviation >= least && deviation <= most, QByteArray::number(deviation));
  }

  void a_device_with_all_of_them_lies_in_table_1s_band_data() {
    QTest::addColumn<QString>("axis");
    for (const char* axis : {"x", "y", "z"}) QTest::newRow(axis) << QString(axis);
  }
  void a_device_with_all_of_them_lies_in_table_1s_band() {
    QFETCH(QString, axis);
    const LineFit line = measure(axis.toUtf8(), {}).line();
    const double error = 1.0 - line.slope / stiffness;
    qInfo("error %.2f %%, R2 %.5f", 100.0 * error, line.r2);
    QVERIFY(error > 0.0 && error < 0.06 && line.r2 > 0.97);
  }
};

QTEST_APPLESS_MAIN(TestImperfections)
#include "tst_imperfections.moc"
