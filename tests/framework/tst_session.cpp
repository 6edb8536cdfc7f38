// SPDX-License-Identifier: Apache-2.0
#include "framework/session.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "framework/logger.hpp"
#include "framework/recording/mcap_reader.hpp"
#include "tests/support/run_rig.hpp"

using namespace trocar;

namespace {

SessionOptions in_virtual_time(SessionOptions options) {
  options.clock = ClockKind::simulated;
  return options;
}

/// A session of one meter and a device.
struct SessionRig {
  explicit SessionRig(SessionOptions options)
      : session(types, in_virtual_time(std::move(options))) {
    session.graph().add("Meter", "meter", {"test", 1});
    session.graph().add("TestDevice", "arm", {"test", 2});
  }
  SessionRig(const SessionRig&) = delete;
  SessionRig& operator=(const SessionRig&) = delete;

  void log_to(const std::string& file, const char* recorded = "all") {
    const NodeId logger = session.graph().add("Logger", "logger", {"test", 3}).value();
    session.graph().set({logger, "file"}, {file}, {"test", 3});
    session.graph().set({logger, "signals"}, literal_from_text(recorded), {"test", 3});
  }

  Registry types = [] {
    Registry all = test::registry();
    all.add<test::Meter>("Meter", "test", "numbers that follow from the tick");
    all.add<Logger>("Logger", "test", "records");
    return all;
  }();
  Session session;
};

double last_value(const SessionRun& run) {
  return run.result.rows->column(*run.result.rows->find("meter.value")).back();
}

}  // namespace

class TestSession : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_duration_is_the_options_then_the_scripts_then_the_default() {
    SessionRig by_option({.duration = 0.02});
    QCOMPARE(by_option.session.run(test::wanted(0.5)).result.main().loop.ticks, std::int64_t{20});
    SessionRig by_script({});
    QCOMPARE(by_script.session.run(test::wanted(0.5)).result.main().loop.ticks, std::int64_t{500});
    SessionRig by_nobody({.default_duration = 0.3});
    QCOMPARE(by_nobody.session.run(test::wanted()).result.main().loop.ticks, std::int64_t{300});
  }

  void in_real_time_there_is_no_default_duration() {
    Registry types;
    StopFlag stop;
    stop.raise();
    Session session(types, {.clock = ClockKind::realtime, .default_duration = 0.3, .stop = &stop});
    const RunResult& result = session.run(test::wanted()).result;
    QVERIFY(result.interrupted);
    QCOMPARE(result.clock, ClockKind::realtime);
    QCOMPARE(result.main().loop.ticks, std::int64_t{0});
  }

  void what_is_set_from_outside_wins_over_the_script_and_over_a_run() {
    SessionRig rig({.set = {{"meter.gain", {literal_from_text("5 N"), {"--set", 0}}}}});
    Graph& graph = rig.session.graph();
    graph.set({*graph.find("meter"), "gain"}, literal_from_text("3 N"), {"test", 4});
    RunOptions wanted = test::wanted(0.001);
    QCOMPARE(last_value(rig.session.run(wanted)), 5.0);
    wanted.wiring.set["meter.gain"] = {literal_from_text("4 N"), {"test", 5}};
    QCOMPARE(last_value(rig.session.run(wanted)), 5.0);
  }

  void a_run_may_set_what_the_options_leave() {
    SessionRig rig({});
    RunOptions wanted = test::wanted(0.001);
    wanted.wiring.set["meter.gain"] = {literal_from_text("4 N"), {"test", 5}};
    QCOMPARE(last_value(rig.session.run(wanted)), 4.0);
    QCOMPARE(last_value(rig.session.run(test::wanted(0.001))), 2.0);
  }

  void a_logger_records_and_record_redirects_it() {
    SessionRig plain({});
    plain.log_to(file("script.mcap"));
    plain.session.run(test::wanted(0.01));
    plain.session.finish();
    QCOMPARE(plain.session.log_path(), file("script.mcap"));
    QCOMPARE(McapReader(file("script.mcap")).message_count(), std::uint64_t{12});

    SessionRig redirected({.record = file("option.mcap")});
    redirected.log_to(file("never.mcap"), "meter.count");
    redirected.session.add_script("rig.lua", "-- text");
    redirected.session.run(test::wanted(0.01));
    redirected.session.publish("step", literal_from_text("force = 1"));
    redirected.session.finish();
    QVERIFY(!QFile::exists(QString::fromStdString(file("never.mcap"))));
    const McapReader log(file("option.mcap"));
    log.verify();
    QStringList attached;
    for (const auto& one : log.attachments()) attached << QString::fromStdString(one.name);
    QCOMPARE(attached, QStringList({"rig.lua", "graph.json", "run1.json"}));
    QVERIFY(log.channel("/published") != nullptr);
    const std::string& schema = log.schemas().at(log.channel("/main")->schema_id).data;
    QVERIFY(schema.find("int64 count") != std::string::npos);
    QVERIFY(schema.find("float64 value") == std::string::npos);
    QVERIFY(redirected.session.sound());
  }

  void without_a_wish_nothing_is_recorded() {
    SessionRig rig({});
    rig.session.run(test::wanted(0.01));
    rig.session.publish("step", literal_from_text("force = 1"));
    rig.session.finish();
    QVERIFY(rig.session.log_path().empty());
    QCOMPARE(rig.session.published().size(), std::size_t{1});
    QVERIFY(rig.session.sound());
  }

  void a_broken_graph_begins_no_log() {
    SessionRig rig({.record = file("broken.mcap")});
    rig.session.graph().add("Nonsense", "", {"test", 9});
    QVERIFY_THROWS_EXCEPTION(BrokenGraph, rig.session.run(test::wanted(0.01)));
    QVERIFY(!QFile::exists(QString::fromStdString(file("broken.mcap"))));
  }

  void a_fault_makes_a_session_unsound() {
    SessionRig rig({});
    RunOptions wanted = test::wanted(0.01);
    wanted.wiring.set["meter.broken_from"] = {literal_from_text("3"), {"test", 5}};
    rig.session.run(wanted);
    QVERIFY(!rig.session.sound());
  }

 private:
  std::string file(const char* name) const { return folder_.filePath(name).toStdString(); }
  QTemporaryDir folder_;
};

QTEST_APPLESS_MAIN(TestSession)
#include "tst_session.moc"
