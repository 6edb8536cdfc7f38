// SPDX-License-Identifier: Apache-2.0
#include "components/devices/simulated_laparoscope.hpp"

// Before Qt, whose macros take words that the framework uses.
#include "tests/support/laparoscope_rig.hpp"

#include <QTest>

using namespace trocar;
using namespace trocar::test;

namespace {

Vector6d truth(const LaparoscopeRig& rig) {
  return rig.device->truth.position->head<6>();
}

}  // namespace

class TestSimulatedLaparoscope : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void encoders_count_in_steps_and_say_so() {
    LaparoscopeRig rig;
    rig.start();
    rig.run(10);
    const auto& steps = rig.device->device_position.quality.resolution;
    QCOMPARE(steps.size(), std::size_t(6));
    QCOMPARE(steps[0], 2e-6);
    QVERIFY(std::abs(steps[5] - 1.02e-4) < 1e-6);
    for (int i = 0; i < 6; ++i) {
      const double counts = (*rig.device->device_position)[i] / steps[static_cast<std::size_t>(i)];
      QVERIFY(std::abs(counts - std::round(counts)) < 1e-6);
    }
    const double off = (rig.device->device_position->head<6>() - truth(rig)).norm();
    QVERIFY2(off > 1e-4, "homed without an error");
  }

  void an_ideal_device_reports_the_truth() {
    LaparoscopeRig rig(Settings{{"laparoscope.ideal", "true"}, {"laparoscope.hand", "push"}});
    rig.start();
    rig.run(1200);
    QVERIFY(rig.device->device_position.quality.resolution.empty());
    QVERIFY(rig.device->device_position->head<6>() == truth(rig));
    QVERIFY((rig.tool->tip->position.eigen() - rig.device->truth.tip->position.eigen()).norm() <
            1e-15);
    QVERIFY(rig.device->truth.tip->position.z > .09);
  }

  void each_imperfection_has_its_switch_data() {
    QTest::addColumn<QByteArray>("parameter");
    for (const char* name : {"friction", "stribeck", "gain_error", "ripple", "cogging",
                             "compliance", "quantisation", "homing_error", "weight_error"})
      QTest::newRow(name) << QByteArray(name);
  }
  void each_imperfection_has_its_switch() {
    QFETCH(QByteArray, parameter);
    const auto end = [&](const char* value) {
      LaparoscopeRig rig(Settings{{"laparoscope.hand", "push"},
                                  {"laparoscope.device." + parameter.toStdString(), value}});
      rig.start();
      rig.run(800);
      return truth(rig);
    };
    const double differs = (end("true") - end("false")).norm();
    QVERIFY2(differs > 1e-8, QByteArray::number(differs));
  }

  void a_command_acts_after_the_delay_data() {
    QTest::addColumn<int>("delay");
    QTest::newRow("at once") << 0;
    QTest::newRow("one tick") << 1;
    QTest::newRow("two ticks") << 2;
  }
  void a_command_acts_after_the_delay() {
    QFETCH(int, delay);
    LaparoscopeRig rig(Settings{{"laparoscope.ideal", "true"},
                                {"laparoscope.device.delay", std::to_string(delay)},
                                {"wall.constant", "1 N"}});
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    const Joints weight = *rig.device->effort_applied;
    std::vector<Vector6d> sent;
    for (int k = 0; k < 50; ++k) {
      rig.tick();
      sent.emplace_back(rig.device->effort_sent->head<6>());
      if (k < delay) continue;
      QVERIFY(rig.device->effort_applied->head<6>() == sent[static_cast<std::size_t>(k - delay)]);
      const bool moves = rig.device->truth.velocity->head<6>().norm() > 1e-9;
      QCOMPARE(moves, k > delay);
    }
    QVERIFY((sent[0] - weight.head<6>()).norm() > 0.1);
  }

  void the_watchdog_ends_the_last_command_data() {
    QTest::addColumn<int>("skipped");
    QTest::addColumn<bool>("falls");
    QTest::newRow("no slot skipped") << 0 << false;
    QTest::newRow("held for 8 ms after the last arrival") << 8 << false;
    QTest::newRow("no longer") << 9 << true;
    QTest::newRow("a hang") << 40 << true;
  }
  void the_watchdog_ends_the_last_command() {
    QFETCH(int, skipped);
    QFETCH(bool, falls);
    LaparoscopeRig rig(Settings{{"laparoscope.ideal", "true"}});
    rig.start();
    rig.run(20);
    rig.skip(skipped);
    const double speed = rig.device->truth.tip->velocity.z;
    if (!falls) {
      QVERIFY(std::abs(speed) < 1e-12);
      return;
    }
    // 11.9 N of weight on 1.21 kg: it fell for what was left of the gap.
    const double expected = -11.886 / 1.21 * 1e-3 * (skipped - 8);
    QVERIFY2(std::abs(speed / expected - 1.0) < 0.03, QByteArray::number(speed));
  }

  void a_gap_of_seconds_is_bounded_and_ends_in_a_trip() {
    LaparoscopeRig rig;
    rig.start();
    rig.run(20);
    rig.skip(1'000'000);
    rig.run(20);
    QVERIFY(truth(rig).allFinite());
    QVERIFY(rig.device->truth.tip->position.z < .06);
    QVERIFY(rig.fault(FaultCause::overload) != nullptr);
    QVERIFY(rig.state() == Gate::State::tripped);
  }

  void cold_it_stands_on_its_brake_until_it_is_held() {
    LaparoscopeRig rig(Settings{
        {"laparoscope.start", "cold"}, {"laparoscope.ideal", "true"}, {"wall.constant", "1 N"}});
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    const Vector6d before = truth(rig);
    const double height = rig.device->truth.tip->position.z;
    rig.run(900);
    QVERIFY(truth(rig) == before);
    QVERIFY(rig.state() == Gate::State::cold);
    rig.run(600);
    QVERIFY(rig.state() == Gate::State::holding);
    QCOMPARE(*rig.device->scale, 0.0);
    const double sunk = height - rig.device->truth.tip->position.z;
    qInfo("sinks by %.3g mm as the brake lets go", 1e3 * sunk);
    QVERIFY(sunk > 0.0 && sunk < 1e-4);
  }

  void cold_it_engages_when_asked_and_calm() {
    Command engage;
    engage.kind = Command::Kind::engage;
    engage.not_before = 1200;
    LaparoscopeRig rig(Settings{
        {"laparoscope.start", "cold"}, {"laparoscope.hand", "firm"}, {"wall.constant", "0.5 N"}});
    rig.place("TestFixture", "wall", "tip");
    rig.start({engage});
    rig.run(1450);
    QVERIFY(rig.state() == Gate::State::holding);
    rig.run(1500);
    QVERIFY(rig.state() == Gate::State::engaged);
    QCOMPARE(*rig.device->scale, 1.0);
  }

  void cold_and_without_hold_it_stays_locked() {
    Registry registry;
    register_components(registry);
    Graph graph(registry);
    const NodeId node = *graph.add("SimulatedLaparoscope", "", {"test", 1});
    graph.set({node, "start"}, {std::string("cold")}, {"test", 1});
    const auto wired = wire(graph, {});
    const auto& device = static_cast<SimulatedLaparoscope&>(*wired->component(node));
    Executor executor(wired->main(), {.timing = false});
    executor.start();
    const Vector6d before = device.truth.position->head<6>();
    for (std::int64_t k = 0; k < 2000; ++k) executor.tick({k, 0, 0}, true);
    QVERIFY(device.truth.position->head<6>() == before);
  }

  void engaged_and_without_hold_it_falls() {
    Registry registry;
    register_components(registry);
    Graph graph(registry);
    const NodeId node = *graph.add("SimulatedLaparoscope", "", {"test", 1});
    const auto wired = wire(graph, {});
    const auto& device = static_cast<SimulatedLaparoscope&>(*wired->component(node));
    Executor executor(wired->main(), {.timing = false});
    executor.start();
    for (std::int64_t k = 0; k < 100; ++k) executor.tick({k, 0, 0}, true);
    QVERIFY(device.truth.tip->position.z < .08);
  }

  void rendering_is_scaled_to_the_handles_cap_and_keeps_its_direction() {
    LaparoscopeRig rig(Settings{{"wall.constant", "35 N"}, {"laparoscope.hand", "firm"}});
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    rig.run(4);
    QVERIFY(!rig.executor->faults().latched());
    QVERIFY(std::abs(*rig.device->scale - 20.0 / 35.0) < 1e-9);
    const Vector6d rendered = rig.device->effort_sent->head<6>() - rig.device->hold->head<6>();
    const Vector6d asked = rig.device->effort->head<6>();
    QVERIFY((rendered - *rig.device->scale * asked).norm() < 1e-9);
  }

  void the_handles_moment_counts_as_well() {
    LaparoscopeRig rig(Settings{{"wall.constant", "10 N"},
                                {"laparoscope.handle_offset", "-150 mm"},
                                {"laparoscope.hand", "firm"}});
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    rig.run(4);
    QVERIFY(!rig.executor->faults().latched());
    // 10 N at 150 mm from the handle: 1.5 N m against 1 N m
    QVERIFY(std::abs(*rig.device->scale - 1.0 / 1.5) < 1e-3);
  }

  void twice_the_cap_trips_and_the_first_cause_stays() {
    LaparoscopeRig rig(Settings{{"wall.constant", "41 N"}, {"laparoscope.hand", "firm"}});
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    rig.run(2);
    QVERIFY(rig.executor->faults()[0].cause == FaultCause::handle_wrench);
    QVERIFY(rig.state() == Gate::State::tripped);
    QVERIFY(rig.device->hold->head<3>().norm() > 1.0);
  }

  void impossible_settings_are_findings_data() {
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("a start outside the workspace")
        << QByteArray("start_position") << QByteArray("0, 0, 160 mm")
        << QByteArray("slider_1_high");
    QTest::newRow("a start that no link reaches")
        << QByteArray("start_position") << QByteArray("1 m, 0, 85 mm")
        << QByteArray("start inside");
    QTest::newRow("a push without direction")
        << QByteArray("push_direction") << QByteArray("0, 0, 0") << QByteArray("has no length");
    QTest::newRow("links that are too short")
        << QByteArray("link_length") << QByteArray("50 mm") << QByteArray("link_length");
    QTest::newRow("a delay beyond a command's deadline")
        << QByteArray("delay") << QByteArray("3") << QByteArray("0–2");
    QTest::newRow("a physics step that is too coarse")
        << QByteArray("physics_step") << QByteArray("1 ms") << QByteArray("0.1 ms");
  }
  void impossible_settings_are_findings() {
    QFETCH(QByteArray, key);
    QFETCH(QByteArray, value);
    QFETCH(QByteArray, says);
    Registry registry;
    register_components(registry);
    Graph graph(registry);
    const NodeId node = *graph.add("SimulatedLaparoscope", "", {"test", 1});
    graph.set({node, key.toStdString()}, literal_from_text(value.toStdString()), {"test", 1});
    const Findings findings = check(graph, {});
    QCOMPARE(findings.all().size(), std::size_t(1));
    const QByteArray text = QByteArray::fromStdString(findings.text());
    QVERIFY2(text.contains(says), text);
  }

  void what_only_the_simulation_knows_cannot_be_rendered() {
    LaparoscopeRig rig;
    const NodeId wall = *rig.graph.add("TestFixture", "wall", {"test", 1});
    Site site = rig.graph.node(rig.group).exports.sites.at("tip");
    const NodeId device = rig.graph.node(rig.group).exports.parts.at("device");
    site.position = {device, "truth.tip", "position"};
    rig.graph.place(wall, site, {"test", 1});
    const Findings findings = check(rig.graph, {});
    QVERIFY2(findings.text().find("only a simulation knows") != std::string::npos,
             findings.text().c_str());
  }

  void the_seed_makes_the_device() {
    const auto reported = [](std::uint64_t seed) {
      Registry registry;
      register_components(registry);
      Graph graph(registry);
      const NodeId node = *graph.add("SimulatedLaparoscope", "", {"test", 1});
      const auto wired = wire(graph, {.seed = seed});
      wired->component(node)->start();
      return Vector6d(
          static_cast<SimulatedLaparoscope&>(*wired->component(node)).device_position->head<6>());
    };
    QVERIFY(reported(1) == reported(1));
    QVERIFY(reported(1) != reported(2));
  }
};

QTEST_APPLESS_MAIN(TestSimulatedLaparoscope)
#include "tst_simulated_laparoscope.moc"
