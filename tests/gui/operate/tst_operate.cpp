// SPDX-License-Identifier: Apache-2.0
// What an operator is told, from rows and events made by hand.
#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>
#include <nlohmann/json.hpp>

#include "gui/operate/events.hpp"
#include "gui/operate/operator.hpp"
#include "gui/operate/rendering.hpp"
#include "gui/window/loop_strip.hpp"
#include "tests/gui/track_rig.hpp"

using namespace trocar;
using namespace trocar::gui;
using trocar::test::TrackRig;

namespace {

enum Number { scale, applied, hold, device_state, dead_man, numbers };

struct Rig : TrackRig {
  Rig() : TrackRig({"scale", "applied", "hold", "device_state", "dead_man"}) {
    signals_seen.device = "arm";
    signals_seen.scale = "scale";
    signals_seen.applied = "applied";
    signals_seen.hold = "hold";
    values[scale] = 1.0;
  }
  void with_device_states() {
    signals_seen.device_state = "device_state";
    signals_seen.device_states = {"unhomed", "homing", "ready", "engaged", "fault"};
    signals_seen.dead_man = "dead_man";
  }
  void rows(int count, std::int64_t flags, std::int64_t lateness_ns = 0) {
    for (int i = 0; i < count; ++i, ++tick)
      track->add(row({.tick = tick,
                      .time = tick * 1'000'000,
                      .lateness = lateness_ns,
                      .duration = 100'000,
                      .flags = flags},
                     {values, values + numbers}));
  }
  void event(const std::string& kind, const std::string& source, const std::string& detail) {
    store.add_event({.tick = tick,
                     .time = 1e-3 * static_cast<double>(tick),
                     .thread = "main",
                     .kind = kind,
                     .source = source,
                     .detail = detail});
  }
  RunStatus status() { return RunStatus::of({store}, signals_seen); }

  NamedSignals signals_seen;
  double values[numbers] = {};
  std::int64_t tick = 0;
};

nlohmann::json device_graph(bool truth) {
  return {{"nodes",
           {{{"name", "arm"},
             {"type", "Arm"},
             {"device", true},
             {"parameters", {{{"name", "handle_force_cap"}, {"si", {20.0}}}}},
             {"outputs",
              {{{"name", "effort_applied"}, {"truth", false}},
               {{"name", "device_state"}, {"truth", false}, {"labels", {"unhomed", "engaged"}}},
               {{"name", "where_it_is"}, {"truth", truth}}}}},
            {{"name", "soft"},
             {"type", "Anything"},
             {"category", "fixtures"},
             {"outputs", {{{"name", "force"}}, {{"name", "depth"}}}}}}},
          {"groups", {{{"sites", {{"tip", {{"position", "arm.tip.position"}}}}}}}},
          {"wires", {{{"from", "weight.effort"}, {"to", "arm.hold"}}}}};
}

}  // namespace

class TestOperate : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void what_to_show_is_found_by_what_is_declared() {
    const NamedSignals found = NamedSignals::of(device_graph(true));
    QCOMPARE(found.device, std::string("arm"));
    QCOMPARE(found.applied, std::string("arm.effort_applied"));
    QCOMPARE(found.hold, std::string("weight.effort"));
    QCOMPARE(found.tip, std::string("arm.tip.position"));
    QCOMPARE(found.force_cap, 20.0);
    QCOMPARE(found.device_states.size(), std::size_t{2});
    QCOMPARE(found.fixtures.size(), std::size_t{1});
    QCOMPARE(found.fixtures[0].depth, std::string("soft.depth"));
    for (const char* odd : {"null", "[]", "{\"nodes\": 3, \"wires\": [1]}",
                            "{\"nodes\": [7, {\"outputs\": [1]}], \"groups\": [{}]}"})
      QVERIFY(NamedSignals::of(nlohmann::json::parse(odd)).device.empty());
  }

  void modes_data() {
    QTest::addColumn<bool>("linked");
    QTest::addColumn<bool>("truth");
    QTest::addColumn<QString>("mode");
    QTest::newRow("a device that knows its truth is simulated") << true << true << "SIMULATED";
    QTest::newRow("any other is live") << true << false << "LIVE";
    QTest::newRow("without a link it is a replay") << false << true << "REPLAY";
  }
  void modes() {
    QFETCH(bool, linked);
    QFETCH(bool, truth);
    Rig rig;
    rig.rows(1, 0);
    StreamClient link;
    const Sources sources{rig.store, linked ? &link : nullptr, nullptr};
    const RunStatus status = RunStatus::of(sources, NamedSignals::of(device_graph(truth)));
    QTEST(QString(to_string(status.mode)), "mode");
  }

  void the_state_is_the_devices_echo_data() {
    QTest::addColumn<QString>("gate");
    QTest::addColumn<int>("flags");
    QTest::addColumn<int>("device");  // its own state, -1: it has none
    QTest::addColumn<QString>("state");
    QTest::newRow("rendering") << "engaged" << 2 << -1 << "ENGAGED";
    QTest::newRow("rendering, nothing heard of the gate") << "" << 2 << -1 << "ENGAGED";
    QTest::newRow("the ramp of engaging") << "engaging" << 2 << -1 << "ENGAGING";
    QTest::newRow("held") << "holding" << 0 << -1 << "HOLDING";
    QTest::newRow("cold") << "cold" << 0 << -1 << "NOT READY";
    QTest::newRow("tripped") << "tripped" << 1 << -1 << "STOPPED";
    QTest::newRow("a fault, nothing heard of the gate") << "" << 1 << -1 << "STOPPED";
    QTest::newRow("a fault beside the rendering") << "engaged" << 3 << -1 << "ENGAGED";
    QTest::newRow("the gate stopped, the device did not") << "tripped" << 1 << 3 << "ENGAGED";
    QTest::newRow("the gate lets pass, the device not yet") << "engaged" << 2 << 2 << "ENGAGING";
    QTest::newRow("both") << "engaged" << 2 << 3 << "ENGAGED";
    QTest::newRow("both in the ramp") << "engaging" << 2 << 3 << "ENGAGING";
    QTest::newRow("the device looks for its references") << "cold" << 0 << 1 << "NOT READY";
  }
  void the_state_is_the_devices_echo() {
    QFETCH(QString, gate);
    QFETCH(int, flags);
    QFETCH(int, device);
    Rig rig;
    if (device >= 0) rig.with_device_states();
    rig.values[device_state] = device;
    if (!gate.isEmpty()) rig.event("gate", "arm", gate.toStdString());
    rig.rows(10, flags);
    QTEST(QString(to_string(rig.status().state)), "state");
  }

  void the_hand_is_told_where_there_is_a_switch() {
    Rig rig;
    rig.rows(1, 0);
    QVERIFY(!rig.status().hand);
    rig.with_device_states();
    QCOMPARE(rig.status().hand, std::optional(false));
    rig.values[dead_man] = 1.0;
    rig.rows(1, 0);
    QCOMPARE(rig.status().hand, std::optional(true));
  }

  void health_of_the_loop() {
    Rig rig;
    rig.rows(2000, 2, 30'000);
    rig.tick += 3;
    rig.rows(10, 2, 30'000);
    const RunStatus status = rig.status();
    QCOMPARE(status.missed, std::uint64_t{3});
    QVERIFY(std::abs(status.rate - 1000.0) < 1.0);
    QVERIFY(std::abs(status.late_p99 - 30e-6) < 1e-9);
    QVERIFY(std::abs(status.margin - 0.87) < 1e-3);
    QCOMPARE(
        LoopStrip::text(status),
        QString("LOOP 1000 Hz   late p99 30 µs   margin 87 %   missed 3   time 2.0 s   tick 2012"));
    QCOMPARE(LoopStrip::text(RunStatus()), QString("LOOP: no rows yet"));
  }

  void what_is_not_heard_is_not_known() {
    Rig rig;
    rig.rows(10, 2);
    StreamClient link;  // closed
    const Sources sources{rig.store, &link, nullptr};
    const RunStatus status = RunStatus::of(sources, rig.signals_seen);
    QCOMPARE(to_string(status.state), "UNKNOWN");
    QCOMPARE(status.state_note, std::string("the device may still be engaged"));
    QVERIFY(status.stale());
    const RunStatus ended = RunStatus::of(sources, rig.signals_seen, {.runtime_ended = true});
    QCOMPARE(to_string(ended.state), "RUN ENDED");
    rig.store.begin_run({});
    QCOMPARE(to_string(RunStatus::of(sources, rig.signals_seen).state), "NO RUN");
  }

  void rendering_is_seen_by_gate_and_device_data() {
    QTest::addColumn<int>("flags");
    QTest::addColumn<int>("device");
    QTest::addColumn<double>("force");
    QTest::addColumn<double>("weight");
    QTest::addColumn<bool>("rendering");
    QTest::newRow("the gate lets effort pass") << 2 << -1 << 4.0 << 4.0 << true;
    QTest::newRow("nothing but the weight") << 1 << -1 << 40.0 << 40.0 << false;
    QTest::newRow("the weight and damping") << 1 << -1 << 44.9 << 40.0 << false;
    QTest::newRow("more than the weight") << 1 << -1 << 47.0 << 40.0 << true;
    QTest::newRow("nothing at all, where a weight should be") << 1 << -1 << 0.0 << 40.0 << false;
    QTest::newRow("what is not a number") << 1 << -1 << std::nan("") << 4.0 << true;
    QTest::newRow("the device says it is engaged") << 1 << 3 << 4.0 << 4.0 << true;
    QTest::newRow("the device says it is ready") << 1 << 2 << 4.0 << 4.0 << false;
  }
  void rendering_is_seen_by_gate_and_device() {
    QFETCH(int, flags);
    QFETCH(int, device);
    QFETCH(double, force);
    QFETCH(double, weight);
    Rig rig;
    if (device >= 0) rig.with_device_states();
    rig.values[device_state] = device;
    rig.values[applied] = force;
    rig.values[hold] = weight;
    rig.rows(1, flags);
    QTEST(renders(rig.store, rig.signals_seen), "rendering");
  }

  void alarms_stay_with_the_first_cause_on_top() {
    Rig rig;
    AlarmModel alarms(rig.store);
    const QAbstractItemModelTester tester(&alarms);
    QVERIFY(alarms.first() == nullptr);
    rig.rows(100, 2);
    rig.event("fault", "arm", "speed: handle");
    rig.rows(100, 1);
    rig.event("fault", "wall", "not finite: force");
    rig.event("fault", "arm", "speed: handle");
    rig.event("started", "", "");
    QCOMPARE(alarms.rowCount(), 2);
    QCOMPARE(alarms.first()->cause, QString("speed: handle"));
    QCOMPARE(alarms.first()->tick, 100);
    QCOMPARE(alarms.first()->count, 2);
    QCOMPARE(AlarmModel::text(*alarms.first(), 60.1),
             QString("60 s ago, tick 100, 2 times  arm: speed: handle"));
    QCOMPARE(alarms.index(0, AlarmModel::state).data(), QVariant("LATCHED"));
    rig.event("acknowledge refused", "arm", "");
    QVERIFY(alarms.first() != nullptr);
    rig.rows(100, 1);
    rig.event("acknowledged", "arm", "");
    QVERIFY(alarms.first() == nullptr);
    QCOMPARE(alarms.rowCount(), 2);  // told, and kept
    rig.event("fault", "arm", "speed: handle");
    QCOMPARE(alarms.rowCount(), 3);
    QCOMPARE(alarms.first()->count, 1);
    rig.begin();
    QCOMPARE(alarms.rowCount(), 0);
  }

  void of_two_devices_both_have_to_acknowledge() {
    for (const bool refused_first : {false, true}) {
      Rig rig;
      AlarmModel alarms(rig.store);
      rig.event("fault", "left", "speed: handle");
      rig.rows(10, 1);
      rig.event(refused_first ? "acknowledge refused" : "acknowledged", "left", "");
      rig.event(refused_first ? "acknowledged" : "acknowledge refused", "right", "");
      QVERIFY(alarms.first() != nullptr);
      rig.rows(10, 1);
      rig.event("acknowledged", "left", "");
      rig.event("acknowledged", "right", "");
      QVERIFY(alarms.first() == nullptr);
    }
  }

  void in_a_replay_alarms_and_events_come_and_go_with_the_place() {
    Rig rig;
    rig.rows(1000, 2);
    rig.store.set_view_end(0.0);
    AlarmModel alarms(rig.store);
    EventModel events(rig.store);
    const QAbstractItemModelTester alarm_tester(&alarms), event_tester(&events);
    rig.tick = 500;
    rig.event("fault", "arm", "speed: handle");
    rig.tick = 800;
    rig.event("acknowledged", "arm", "");
    QCOMPARE(alarms.rowCount(), 0);
    QCOMPARE(events.rowCount(), 0);
    const auto stand_at = [&](double time) {
      rig.store.set_view_end(time);
      alarms.refresh();
      events.refresh();
    };
    stand_at(0.6);
    QVERIFY(alarms.first() != nullptr);
    QCOMPARE(events.rowCount(), 1);
    stand_at(0.9);
    QVERIFY(alarms.first() == nullptr);
    QCOMPARE(events.rowCount(), 2);
    stand_at(0.6);
    QVERIFY(alarms.first() != nullptr);
    stand_at(0.1);
    QCOMPARE(alarms.rowCount(), 0);
    QCOMPARE(events.rowCount(), 0);
  }

  void events_are_kept_in_order_also_when_the_oldest_go() {
    Rig rig;
    const auto more = [&](std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) {
        ++rig.tick;
        rig.event("annotated", "", "remark");
      }
    };
    more(DataStore::most_events - 2);
    EventModel events(rig.store);
    const QAbstractItemModelTester tester(&events);
    more(7);
    QCOMPARE(events.rowCount(), static_cast<int>(DataStore::most_events));
    QCOMPARE(events.index(0, EventModel::tick).data().toLongLong(), 6);
  }

  void a_replay_asks_nothing() {
    Rig rig;
    rig.rows(10, 2);
    Operator operators({rig.store});
    QSignalSpy remarks(&operators, &Operator::remark);
    operators.stop_control().stop();
    QCOMPARE(operators.stop_control().state(), StopControl::State::idle);
    operators.request("engage");
    QCOMPARE(remarks.size(), 1);
    operators.recording().start();
    QVERIFY(!operators.recording().recording());
    QVERIFY(!operators.parameters().may_write());
  }
};

QTEST_GUILESS_MAIN(TestOperate)
#include "tst_operate.moc"
