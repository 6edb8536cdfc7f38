// SPDX-License-Identifier: Apache-2.0
// Each parameter of the simulated device sets what it says and nothing else.
#include "components/devices/simulated_laparoscope.hpp"

#include <QTest>
#include <numbers>

using namespace trocar;

namespace {

using Settings = LaparoscopePlantSettings;

/// Everything that the parameters make, as numbers.
std::vector<std::pair<std::string, double>> numbers(const SimulatedLaparoscope& device) {
  const Settings s = device.plant_settings({});
  std::vector<std::pair<std::string, double>> all;
  for (const auto& [kind, a] : {std::pair("slider", s.drive.slider), {"ring", s.drive.ring}})
    for (const auto& [name, value] :
         std::initializer_list<std::pair<const char*, double>>{{"peak", a.peak},
                                                               {"continuous", a.continuous},
                                                               {"viscous", a.viscous},
                                                               {"coulomb", a.coulomb},
                                                               {"stribeck_speed", a.stribeck_speed},
                                                               {"ripple_pitch", a.ripple_pitch},
                                                               {"cogging", a.cogging},
                                                               {"cogging_pitch", a.cogging_pitch},
                                                               {"resolution", a.resolution},
                                                               {"homing_low", a.homing_low},
                                                               {"homing_high", a.homing_high},
                                                               {"stiffness", a.stiffness},
                                                               {"motor_inertia", a.motor_inertia}})
      all.emplace_back(std::string(kind) + "." + name, value);
  const ThermalSettings& t = s.drive.thermal;
  const HandSettings& h = s.hand;
  const Imperfections& i = s.imperfections;
  all.insert(all.end(), {{"thermal.rise", t.rise},
                         {"thermal.time", t.time},
                         {"thermal.derating_start", t.derating_start},
                         {"thermal.magnet_share", t.magnet_share},
                         {"thermal.magnet_time", t.magnet_time},
                         {"thermal.gain_loss", t.gain_loss},
                         {"dac_bits", s.drive.dac_bits},
                         {"gain", s.drive.gain},
                         {"gain_spread", s.drive.gain_spread},
                         {"ripple", s.drive.ripple},
                         {"static_friction", s.drive.static_friction},
                         {"transmission_damping", s.drive.transmission_damping},
                         {"masses.tool", s.masses.tool},
                         {"masses.tool_centre", s.masses.tool_centre},
                         {"masses.slider", s.masses.slider},
                         {"hand.mode", static_cast<double>(h.mode)},
                         {"hand.relaxed_grip", h.relaxed_grip},
                         {"hand.mass", h.mass},
                         {"hand.damping", h.damping},
                         {"hand.stiffness", h.stiffness},
                         {"hand.rotational_damping", h.rotational_damping},
                         {"hand.rotational_stiffness", h.rotational_stiffness},
                         {"push.bow", h.push.bow.x()},
                         {"push.depth", h.push.depth},
                         {"push.start", h.push.start},
                         {"push.rise", h.push.rise},
                         {"push.dwell", h.push.dwell}});
  all.insert(all.end(), {{"with viscous", i.viscous_friction},
                         {"with coulomb", i.coulomb_friction},
                         {"with stribeck", i.stribeck},
                         {"with gain_error", i.gain_error},
                         {"with gain_drift", i.gain_drift},
                         {"with ripple", i.force_ripple},
                         {"with cogging", i.cogging},
                         {"with dac", i.effort_quantisation},
                         {"with saturation", i.saturation},
                         {"with derating", i.derating},
                         {"with compliance", i.compliance},
                         {"with encoders", i.position_quantisation},
                         {"with homing", i.homing_error}});
  return all;
}

}  // namespace

class TestSimulatedParameters : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_parameter_sets_what_it_says_and_nothing_else_data() {
    QTest::addColumn<QString>("value");
    QTest::addColumn<QStringList>("becomes");
    const auto row = [](const char* parameter, const char* value, const QStringList& becomes) {
      QTest::newRow(parameter) << QString(value) << becomes;
    };
    row("slider_peak", "150 N", {"slider.peak=150"});
    row("ring_peak", "9 N m", {"ring.peak=9"});
    row("slider_continuous", "50 N", {"slider.continuous=50"});
    row("ring_continuous", "2 N m", {"ring.continuous=2"});
    row("winding_rise", "100 K", {"thermal.rise=100"});
    row("winding_time", "30 s", {"thermal.time=30"});
    row("derating_start", "70 %", {"thermal.derating_start=0.7"});
    row("drive_gain", "0.95", {"gain=0.95"});
    row("gain_spread", "0.01", {"gain_spread=0.01"});
    row("gain_loss", "0.2 %/K", {"thermal.gain_loss=0.002"});
    row("magnet_share", "40 %", {"thermal.magnet_share=0.4"});
    row("magnet_time", "300 s", {"thermal.magnet_time=300"});
    row("ripple_amplitude", "1 %", {"ripple=0.01"});
    row("slider_ripple_pitch", "20 mm", {"slider.ripple_pitch=0.02"});
    row("ring_ripple_pitch", "20 mrad", {"ring.ripple_pitch=0.02"});
    row("slider_cogging", "0.1 N", {"slider.cogging=0.1"});
    row("ring_cogging", "2 mN m", {"ring.cogging=0.002"});
    row("slider_cogging_pitch", "10 mm", {"slider.cogging_pitch=0.01"});
    row("ring_cogging_pitch", "10 mrad", {"ring.cogging_pitch=0.01"});
    row("dac_bits", "12", {"dac_bits=12"});
    row("slider_resolution", "5 um", {"slider.resolution=5e-06"});
    row("ring_counts", "10000", {"ring.resolution=0.000628319"});
    row("slider_viscous", "4 N s/m", {"slider.viscous=4"});
    row("ring_viscous", "0.1 N m s/rad", {"ring.viscous=0.1"});
    row("slider_coulomb", "1 N", {"slider.coulomb=1"});
    row("ring_coulomb", "0.02 N m", {"ring.coulomb=0.02"});
    row("static_friction", "1.5", {"static_friction=1.5"});
    row("slider_stribeck_speed", "1 mm/s", {"slider.stribeck_speed=0.001"});
    row("ring_stribeck_speed", "0.1 rad/s", {"ring.stribeck_speed=0.1"});
    row("slider_stiffness", "1000 N/mm", {"slider.stiffness=1e+06"});
    row("ring_stiffness", "20 kN m/rad", {"ring.stiffness=20000"});
    row("transmission_damping", "2 %", {"transmission_damping=0.02"});
    row("slider_motor_mass", "100 g", {"slider.motor_inertia=0.1"});
    row("ring_motor_inertia", "2e-3 kg m^2", {"ring.motor_inertia=0.002"});
    row("slider_homing_error", "0.4 mm", {"slider.homing_low=0.0002", "slider.homing_high=0.0004"});
    row("ring_homing_error", "2 mrad", {"ring.homing_high=0.002"});
    row("tool_mass_error", "20 %", {"masses.tool=0.1"});
    row("tool_centre_error", "5 %", {"masses.tool_centre=0.1"});
    row("slider_mass_error", "-20 %", {"masses.slider=0.4"});
    row("hand", "relaxed", {"hand.mode=1"});
    row("relaxed_grip", "20 %", {"hand.relaxed_grip=0.2"});
    row("hand_mass", "200 g", {"hand.mass=0.2"});
    row("hand_damping", "4 N s/m", {"hand.damping=4"});
    row("hand_stiffness", "100 N/m", {"hand.stiffness=100"});
    row("hand_rotational_damping", "0.1 N m s/rad", {"hand.rotational_damping=0.1"});
    row("hand_rotational_stiffness", "3 N m/rad", {"hand.rotational_stiffness=3"});
    row("push_bow", "10 mm, 0, 0", {"push.bow=0.01"});
    row("push_distance", "50 mm", {"push.depth=0.05"});
    row("push_start", "1 s", {"push.start=1"});
    row("push_time", "2 s", {"push.rise=2"});
    row("push_dwell", "4 s", {"push.dwell=4"});
    row("friction", "false", {"with viscous=0", "with coulomb=0"});
    row("stribeck", "false", {"with stribeck=0"});
    row("gain_error", "false", {"with gain_error=0"});
    row("gain_drift", "false", {"with gain_drift=0"});
    row("ripple", "false", {"with ripple=0"});
    row("cogging", "false", {"with cogging=0"});
    row("quantisation", "false", {"with dac=0", "with encoders=0"});
    row("thermal", "false", {"with derating=0"});
    row("compliance", "false", {"with compliance=0"});
    row("homing_error", "false", {"with homing=0"});
    row("weight_error", "false",
        {"masses.tool=0.12", "masses.tool_centre=0.105", "masses.slider=0.32"});
  }
  void a_parameter_sets_what_it_says_and_nothing_else() {
    QFETCH(QString, value);
    QFETCH(QStringList, becomes);
    SimulatedLaparoscope device;
    const auto before = numbers(device);
    ParameterBase* parameter = device.find_parameter(QTest::currentDataTag());
    QVERIFY(parameter != nullptr);
    const std::string wrong = parameter->set(literal_from_text(value.toStdString()));
    QVERIFY2(wrong.empty(), wrong.c_str());
    QStringList changed;
    const auto after = numbers(device);
    for (std::size_t i = 0; i < after.size(); ++i)
      if (after[i].second != before[i].second)
        changed << QString::fromStdString(after[i].first) + "=" + QString::number(after[i].second);
    becomes.sort();
    changed.sort();
    QCOMPARE(changed, becomes);
  }

  void the_plants_own_defaults_are_those_of_the_parameters() {
    const SimulatedLaparoscope device;
    const Settings s = device.plant_settings({});
    const LaparoscopeDriveSettings own;
    QCOMPARE(s.drive.slider.resolution, own.slider.resolution);
    QCOMPARE(s.drive.ring.resolution, own.ring.resolution);
    QCOMPARE(s.drive.ring.motor_inertia, own.ring.motor_inertia);
    QCOMPARE(s.drive.slider.stiffness, own.slider.stiffness);
    QCOMPARE(s.drive.slider.cogging, own.slider.cogging);
    QCOMPARE(s.drive.thermal.gain_loss, own.thermal.gain_loss);
    QCOMPARE(s.drive.transmission_damping, own.transmission_damping);
  }

  void ideal_switches_all_off() {
    SimulatedLaparoscope device;
    QCOMPARE(device.find_parameter("ideal")->set(literal_from_text("true")), std::string());
    for (const auto& [name, value] : numbers(device))
      if (name.starts_with("with ")) QVERIFY2(value == 0.0, name.c_str());
    QCOMPARE(device.plant_settings({}).masses.tool, 0.120);
    QCOMPARE(device.plant_settings({}).masses.slider, 0.320);
  }
};

QTEST_APPLESS_MAIN(TestSimulatedParameters)
#include "tst_simulated_parameters.moc"
