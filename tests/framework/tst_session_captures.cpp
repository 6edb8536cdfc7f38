// SPDX-License-Identifier: Apache-2.0
#include "framework/session_captures.hpp"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "framework/capture.hpp"
#include "framework/report.hpp"
#include "tests/support/log_topic.hpp"
#include "tests/support/mcap_records.hpp"
#include "tests/support/run_rig.hpp"

using namespace trocar;
using test::Topic;

namespace {

/// A session of one meter that breaks at a tick, and whatever a test adds.
struct SessionRig {
  explicit SessionRig(SessionOptions options) : session(types, std::move(options)) {
    meter = session.graph().add("Meter", "meter", {"rig.lua", 1}).value();
    session.add_script("rig.lua", "-- text");
  }
  SessionRig(const SessionRig&) = delete;
  SessionRig& operator=(const SessionRig&) = delete;

  void capture(const char* name, const std::string& file, const char* above) {
    Graph& graph = session.graph();
    const NodeId node = graph.add("Capture", name, {"rig.lua", 5}).value();
    graph.connect({meter, "value"}, {node, "signal"}, {"rig.lua", 5});
    graph.set({node, "file"}, {file}, {"rig.lua", 5});
    graph.set({node, "above"}, literal_from_text(above), {"rig.lua", 5});
    graph.set({node, "before"}, {std::string("50 ms")}, {"rig.lua", 5});
    graph.set({node, "after"}, {std::string("20 ms")}, {"rig.lua", 5});
  }
  const SessionRun& run(double duration, int broken_from = -1) {
    RunOptions wanted;
    wanted.duration = duration;
    if (broken_from >= 0)
      wanted.wiring.set["meter.broken_from"] = {literal_from_text(std::to_string(broken_from)), {}};
    return session.run(wanted);
  }

  Registry types = [] {
    Registry all = test::registry();
    all.add<test::Meter>("Meter", "test", "numbers that follow from the tick");
    all.add<Capture>("Capture", "test", "captures");
    return all;
  }();
  Session session;
  NodeId meter = 0;
};

SessionOptions with_black_box(std::optional<std::string> file = {}) {
  SessionOptions options;
  options.clock = ClockKind::simulated;
  options.black_box = BlackBoxOptions{};
  options.black_box->file = std::move(file);
  return options;
}

}  // namespace

class TestSessionCaptures : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir::setCurrent(folder_->path()));
  }
  void cleanupTestCase() { QDir::setCurrent(QDir::rootPath()); }

  void a_trip_leaves_the_five_seconds_before_it_and_one_after() {
    SessionRig rig(with_black_box());
    const SessionRun& run = rig.run(8.0, 6000);
    QCOMPARE(run.captured.files.size(), std::size_t{1});
    const TriggeredFile& file = run.captured.files[0];
    QCOMPARE(file.path, std::string("rig.blackbox-1.mcap"));
    QCOMPARE(file.cause, std::string("not finite in meter at tick 6000 (6.000 s): an output"));
    const McapReader log(file.path);
    QVERIFY(log.complete());
    log.verify();
    const Topic rows(log, "/main");
    QCOMPARE(rows.numbers.size(), std::size_t{6001});
    QCOMPARE(rows.numbers.front().at("tick"), 1000.0);
    QCOMPARE(rows.numbers[4999].at("meter.value"), 2.0 + 5999);
    QCOMPARE(rows.numbers.back().at("tick"), 7000.0);
    QCOMPARE(rows.times.front(), std::uint64_t{1'000'000'000});
    const Topic events(log, "/events");
    QCOMPARE(events.texts.size(), std::size_t{1});
    QCOMPARE(events.texts[0].at("kind"), std::string("fault"));
    QCOMPARE(log.attachments().size(), std::size_t{3});
    QVERIFY(report_text(rig.session)
                .find("black box: rig.blackbox-1.mcap, 1.000 s to 7.000 s: not finite in meter") !=
            std::string::npos);
    QVERIFY(report_json(rig.session).find("\"file\": \"rig.blackbox-1.mcap\"") !=
            std::string::npos);
  }

  void two_runs_leave_identical_bytes_in_files_of_their_own() {
    for (int i = 0; i < 2; ++i) SessionRig(with_black_box()).run(2.0, 1500);
    const QByteArray first = test::read_bytes("rig.blackbox-1.mcap");
    QVERIFY(first.size() > 100'000);
    QVERIFY(first == test::read_bytes("rig.blackbox-2.mcap"));
  }

  void without_a_fault_there_is_no_file() {
    SessionRig rig(with_black_box());
    QVERIFY(rig.run(1.0).captured.files.empty());
    QVERIFY(QDir().entryList(QDir::Files).empty());
    QVERIFY(rig.session.sound());
  }

  void without_a_wish_there_is_no_black_box() {
    SessionOptions options;
    options.clock = ClockKind::simulated;
    SessionRig rig(options);
    rig.run(0.1, 50);
    QVERIFY(QDir().entryList(QDir::Files).empty());
  }

  void the_black_box_is_named_data() {
    QTest::addColumn<QString>("record");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("name");
    QTest::newRow("after the script") << ""
                                      << ""
                                      << "rig.blackbox-1.mcap";
    QTest::newRow("beside the log") << "logs/trial.mcap"
                                    << ""
                                    << "logs/trial.blackbox-1.mcap";
    QTest::newRow("as it is asked to be") << "logs/trial.mcap"
                                          << "trip.mcap"
                                          << "trip.mcap";
  }
  void the_black_box_is_named() {
    QFETCH(QString, record);
    QFETCH(QString, file);
    QFETCH(QString, name);
    QDir().mkdir("logs");
    SessionOptions options = with_black_box();
    if (!record.isEmpty()) options.record = record.toStdString();
    if (!file.isEmpty()) options.black_box->file = file.toStdString();
    SessionRig rig(options);
    QCOMPARE(rig.run(0.1, 50).captured.files.at(0).path, name.toStdString());
    QVERIFY(QFile::exists(name));
  }

  void a_sessions_runs_count_on_and_keep_the_logs_times() {
    SessionOptions options = with_black_box();
    options.record = "log.mcap";
    SessionRig rig(options);
    rig.run(0.1, 50);
    const SessionRun& second = rig.run(0.1, 50);
    rig.session.finish();
    QCOMPARE(second.captured.files.at(0).path, std::string("log.blackbox-2.mcap"));
    const McapReader log("log.mcap");
    const McapReader box("log.blackbox-2.mcap");
    QCOMPARE(Topic(box, "/main").times, Topic(log, "/run2/main").times);
  }

  void a_session_has_eight_files_and_says_what_is_not_there() {
    SessionRig rig(with_black_box());
    for (int i = 0; i < 9; ++i) rig.run(0.1, 50);
    const CaptureResult& last = rig.session.runs().back()->captured;
    QVERIFY(last.files.empty());
    QCOMPARE(last.notes,
             std::vector<std::string>{"black box: 1 more were not written, a session has 8 files"});
    QCOMPARE(QDir().entryList(QDir::Files).size(), 8);
  }

  void a_capture_writes_what_its_signal_does() {
    SessionRig rig({.clock = ClockKind::simulated});
    rig.capture("touch", "touch.mcap", "102.5 N");
    rig.capture("press", "press.mcap", "152.5 N");
    rig.capture("never", "never.mcap", "1 kN");
    const SessionRun& run = rig.run(0.3);
    QCOMPARE(run.captured.files.size(), std::size_t{2});
    QCOMPARE(run.captured.files[1].writer, std::string("press"));
    const Topic touch(McapReader("touch.mcap"), "/main");
    QCOMPARE(touch.numbers.front().at("tick"), 51.0);
    QCOMPARE(touch.numbers.back().at("tick"), 121.0);
    QCOMPARE(Topic(McapReader("press.mcap"), "/main").numbers.front().at("tick"), 101.0);
    QVERIFY(!QFile::exists("never.mcap"));
    QVERIFY(rig.session.sound());
  }

  void two_that_write_one_file_are_refused_data() {
    QTest::addColumn<QString>("record");
    QTest::addColumn<QString>("second");
    QTest::addColumn<QString>("says");
    QTest::newRow("two captures") << ""
                                  << "touch.mcap"
                                  << "second.file = \"touch.mcap\": that is written by first";
    QTest::newRow("a capture and the log") << "other.mcap"
                                           << "other.mcap"
                                           << "that is written by the log";
  }
  void two_that_write_one_file_are_refused() {
    QFETCH(QString, record);
    QFETCH(QString, second);
    QFETCH(QString, says);
    SessionOptions options{.clock = ClockKind::simulated};
    if (!record.isEmpty()) options.record = record.toStdString();
    SessionRig rig(options);
    rig.capture("first", "touch.mcap", "1 N");
    rig.capture("second", second.toStdString(), "1 N");
    try {
      rig.run(0.1);
      QFAIL("it ran");
    } catch (const BrokenGraph& broken) {
      const QString text = QString::fromStdString(broken.findings.text());
      QVERIFY2(text.contains(says), qPrintable(text));
    }
    QVERIFY2(QDir().entryList(QDir::Files).empty(), "no log was begun");
  }

  void a_disk_that_is_full_is_a_message_and_the_run_goes_on() {
    SessionRig rig({.clock = ClockKind::simulated});
    rig.capture("touch", "/dev/full", "50 N");
    const SessionRun& run = rig.run(0.2);
    QCOMPARE(run.result.main().loop.ticks, std::int64_t{200});
    QVERIFY(run.result.lost.empty());
    QVERIFY(!rig.session.sound());
    QVERIFY(report_text(rig.session).find("LOG: touch: cannot ") != std::string::npos);
  }

  void a_trip_in_real_time_leaves_a_black_box_too() {
    SessionOptions options = with_black_box();
    options.clock = ClockKind::realtime;
    SessionRig rig(options);
    const SessionRun& run = rig.run(0.2, 100);
    QCOMPARE(run.captured.files.size(), std::size_t{1});
    const McapReader log(run.captured.files[0].path);
    log.verify();
    const Topic rows(log, "/main");
    QCOMPARE(rows.numbers.size(), static_cast<std::size_t>(run.result.main().loop.ticks));
    QVERIFY(rows.times.front() > std::uint64_t{1'000'000'000'000'000'000});  // a date
  }

 private:
  std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_APPLESS_MAIN(TestSessionCaptures)
#include "tst_session_captures.moc"
