// SPDX-License-Identifier: Apache-2.0
// The way between host and simulated device: commands that are late, reports that are late or lost.
#include "tests/support/laparoscope_rig.hpp"

#include <QTest>

#include "tests/support/allocation_counter.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

std::pair<std::string, std::string> set(const char* name, const char* value) {
  return {std::string("laparoscope.device.") + name, value};
}

/// Everything that a device can have at once.
Settings everything() {
  return {{"laparoscope.hand", "push"}, set("push_bow", "10 mm, 0, 0"),
          set("delay", "0.7"),          set("report_jitter", "0.5 ms"),
          set("report_loss", "3 %"),    set("report_loss_run", "2"),
          {"wall.damping", "20 N s/m"}};
}

}  // namespace

class TestSimulatedLink : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_command_acts_within_its_tick_data() {
    QTest::addColumn<double>("delay");
    for (const double delay : {0.0, 0.1, 0.25, 0.5, 0.9, 1.0, 1.3, 2.0})
      QTest::addRow("%g of a tick", delay) << delay;
  }
  void a_command_acts_within_its_tick() {
    QFETCH(double, delay);
    LaparoscopeRig rig(Settings{{"laparoscope.ideal", "true"},
                                set("delay", std::to_string(delay).c_str()),
                                {"wall.constant", "1 N"}});
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    rig.run(4);  // three periods passed since the first command
    const double speed = rig.device->truth.tip->velocity.x;
    LaparoscopeRig prompt(
        Settings{{"laparoscope.ideal", "true"}, set("delay", "0"), {"wall.constant", "1 N"}});
    prompt.place("TestFixture", "wall", "tip");
    prompt.start();
    prompt.run(4);
    // The same force from 1 N / m on, for that much shorter.
    const double share = speed / prompt.device->truth.tip->velocity.x;
    QVERIFY2(std::abs(share - (3.0 - delay) / 3.0) < 1e-3, QByteArray::number(share));
  }

  void what_is_applied_changes_as_the_command_arrives() {
    LaparoscopeRig rig(
        Settings{{"laparoscope.ideal", "true"}, set("delay", "0.5"), {"wall.constant", "1 N"}});
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    std::vector<Vector6d> sent;
    for (int k = 0; k < 20; ++k) {
      rig.tick();
      sent.emplace_back(rig.device->effort_sent->head<6>());
      if (k > 0)
        QVERIFY(rig.device->effort_applied->head<6>() == sent[static_cast<std::size_t>(k - 1)]);
    }
  }

  void a_lost_report_leaves_the_last_and_says_how_old_it_is() {
    LaparoscopeRig rig(Settings{{"laparoscope.ideal", "false"},
                                {"laparoscope.hand", "push"},
                                set("push_start", "0 s"),
                                set("report_loss", "20 %"),
                                set("quantisation", "false")});
    rig.start();
    rig.run(300);  // the hand is on its way
    int held = 0;
    Vector6d before = rig.device->device_position->head<6>();
    double age_before = *rig.device->report_age;
    for (int k = 0; k < 400; ++k) {
      rig.tick();
      const Vector6d now = rig.device->device_position->head<6>();
      const double age = *rig.device->report_age;
      if (now == before) {
        ++held;
        QVERIFY(std::abs(age - (age_before + 1e-3)) < 1e-12);
      } else {
        QCOMPARE(age, 0.0);
        const Vector6d off = now - rig.device->truth.motor_position->head<6>();
        QVERIFY(off.norm() < 1.5e-3 + 1e-9);  // homing alone
      }
      before = now;
      age_before = age;
    }
    QVERIFY2(held > 50 && held < 110, QByteArray::number(held));
    QVERIFY(!rig.executor->faults().latched());
  }

  void reports_that_stay_away_end_the_rendering() {
    LaparoscopeRig rig(Settings{{"laparoscope.hand", "firm"},
                                set("report_loss", "5 %"),
                                set("report_loss_run", "50"),
                                set("report_stale", "5 ms")});
    rig.start();
    int k = 0;
    while (k < 20'000 && !rig.executor->faults().latched()) {
      rig.tick();
      ++k;
    }
    QVERIFY(rig.executor->faults()[0].cause == FaultCause::position_lost);
    QVERIFY(*rig.device->report_age > 5e-3 && *rig.device->report_age < 7e-3);
    QVERIFY(rig.state() == Gate::State::tripped);
    QVERIFY(rig.device->effort_sent->head<6>().isZero(0.0));
  }

  void a_late_sample_is_where_the_device_was_then() {
    LaparoscopeRig rig(Settings{{"laparoscope.ideal", "false"},
                                {"laparoscope.hand", "push"},
                                set("push_start", "0 s"),
                                set("quantisation", "false"),
                                set("homing_error", "false"),
                                set("report_jitter", "1 ms")});
    rig.start();
    QCOMPARE(rig.device->device_position.quality.delay, 0.5e-3);
    rig.run(500);
    double oldest = 0.0;
    for (int k = 0; k < 300; ++k) {
      rig.tick();
      const double age = *rig.device->report_age;
      oldest = std::max(oldest, age);
      QVERIFY(age >= 0.0 && age <= 1e-3);
      const Vector6d then =
          rig.device->truth.motor_position->head<6>() - age * rig.device->truth.velocity->head<6>();
      QVERIFY((rig.device->device_position->head<6>() - then).head<3>().norm() < 3e-6);
    }
    QVERIFY(oldest > 0.9e-3);
  }

  void ideal_switches_jitter_and_loss_off() {
    LaparoscopeRig rig(Settings{{"laparoscope.ideal", "true"},
                                {"laparoscope.hand", "push"},
                                set("report_jitter", "1 ms"),
                                set("report_loss", "50 %")});
    rig.start();
    for (int k = 0; k < 800; ++k) {
      rig.tick();
      QVERIFY(rig.device->device_position->head<6>() == rig.device->truth.position->head<6>());
      QCOMPARE(*rig.device->report_age, 0.0);
    }
  }

  void with_everything_on_two_runs_are_alike_to_the_bit() {
    const auto end = [] {
      LaparoscopeRig rig(everything());
      rig.place("TestFixture", "wall", "tip");
      rig.start();
      double sum = 0.0;
      for (int k = 0; k < 2000; ++k) {
        rig.tick();
        sum += rig.device->device_position->head<6>().sum() + *rig.device->report_age +
               rig.device->truth.temperature->head<6>().sum();
      }
      return std::pair(sum, Vector6d(rig.device->truth.position->head<6>()));
    };
    QVERIFY(end() == end());
  }

  void with_everything_on_a_tick_does_not_allocate() {
    LaparoscopeRig rig(everything());
    rig.place("TestFixture", "wall", "tip");
    rig.start();
    QCOMPARE(allocations_in([&] { rig.run(2500); }), 0);
  }

  void impossible_settings_are_findings_data() {
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("a sample from the tick before")
        << QByteArray("report_jitter") << QByteArray("2 ms") << QByteArray("at most a tick, 1 ms");
    QTest::newRow("springs too stiff for the physics")
        << QByteArray("slider_stiffness") << QByteArray("20000 N/mm")
        << QByteArray("physics_step = \"0.1 ms\": at most");
    QTest::newRow("motors heavier than their axes")
        << QByteArray("slider_motor_mass") << QByteArray("400 g")
        << QByteArray("lower slider_motor_mass");
    QTest::newRow("a gain that is no share")
        << QByteArray("relaxed_grip") << QByteArray("120 %") << QByteArray("0–100 %");
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
};

QTEST_APPLESS_MAIN(TestSimulatedLink)
#include "tst_simulated_link.moc"
