// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/log_file.hpp"

#include <QTemporaryDir>
#include <QTest>

#include "components/register.hpp"
#include "framework/recording/mcap_reader.hpp"
#include "tests/support/log_topic.hpp"
#include "tests/support/mcap_records.hpp"
#include "tests/support/run_rig.hpp"
#include "tests/support/size_limit.hpp"

using namespace trocar;
using test::edit_of;
using test::RunRig;
using test::SizeLimit;
using test::TestSink;
using test::Topic;

namespace {

QByteArray log_of_the_laparoscope(const std::string& path, std::uint64_t seed) {
  Registry types;
  register_components(types);
  Graph graph(types);
  graph.overrides["laparoscope.hand"] = {literal_from_text("push"), {"test", 1}};
  graph.build_group(graph.add("Laparoscope", "", {"test", 1}).value());
  LogFile log(path, 0);
  Recorder recorder(log, {});
  RunOptions options = test::wanted(0.7);
  options.wiring.seed = seed;
  options.sinks = {&recorder};
  run(graph, options);
  log.close();
  return test::read_bytes(path);
}

}  // namespace

class TestLogFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void every_value_of_every_row_reads_back() {
    RunRig rig;
    LogFile log(path(), 0);
    Recorder recorder(log, {});
    const RunResult result = rig.run(0.1, {&recorder});
    log.close();
    const McapReader reader(path());
    reader.verify();
    const Topic rows(reader, "/main");
    QCOMPARE(rows.numbers.size(), std::size_t{100});
    for (const RowSignal& signal : result.rows->signals()) {
      const std::vector<double> column = result.rows->column(signal);
      for (std::size_t i = 0; i < column.size(); ++i)
        QVERIFY2(rows.numbers[i].at(signal.name) == column[i], signal.name.c_str());
    }
    for (std::size_t i = 0; i < 100; ++i) {
      QCOMPARE(rows.times[i], i * 1'000'000);
      QCOMPARE(rows.numbers[i].at("tick"), static_cast<double>(i));
      QCOMPARE(rows.numbers[i].at("meter.value"), 2.0 + static_cast<double>(i));
      QCOMPARE(rows.numbers[i].at("meter.odd"), static_cast<double>(i % 2));
    }
  }

  void events_read_back() {
    RunRig rig;
    rig.graph.set({rig.meter, "broken_from"}, literal_from_text("20"), {"test", 3});
    LogFile log(path(), 0);
    Recorder recorder(log, {});
    rig.run(0.05, {&recorder}, {edit_of("meter.gain", "4 N", 0.01)});
    log.close();
    const Topic events(McapReader(path()), "/events");
    QStringList told;
    for (std::size_t i = 0; i < events.texts.size(); ++i)
      told += QString("%1 %2 %3 %4")
                  .arg(events.numbers[i].at("tick"))
                  .arg(events.texts[i].at("kind").c_str(), events.texts[i].at("source").c_str(),
                       events.texts[i].at("detail").c_str())
                  .trimmed();
    QCOMPARE(told, (QStringList{"0 started", "10 edit meter gain",
                                "20 fault meter not finite: an output", "49 ended"}));
    QCOMPARE(events.numbers[1].at("value"), 4.0);
    QCOMPARE(events.times[2], std::uint64_t{20'000'000});
  }

  void what_a_slow_recorder_missed_stands_in_the_log() {
    RunRig rig;
    const std::unique_ptr<WiredGraph> wired = wire(rig.graph, {});
    const std::vector<RowLayout> layouts = layouts_of(*wired);
    const RowLayout& layout = layouts.front();
    const std::vector<std::int64_t> times(wired->main().schedule().size());
    std::vector<std::byte> row(layout.size());
    LogFile log(path(), 0);
    Recorder recorder(log, {});
    recorder.begin(layouts, *wired);
    for (const std::int64_t tick : {0, 121, 122, 130}) {
      if (tick == 121) recorder.missed(120);
      if (tick == 130) recorder.missed(7);
      if (tick == 130) recorder.event(0, {.kind = Event::Kind::ended, .tick = 130});
      layout.capture({.tick = tick, .time = tick * 1'000'000}, times, wired->main().memory(), row);
      recorder.row(0, row);
    }
    recorder.end();
    log.close();
    const McapReader reader(path());
    reader.verify();
    const Topic events(reader, "/events");
    QCOMPARE(events.texts.size(), std::size_t{3});
    for (const std::size_t i : {0u, 1u}) {
      QCOMPARE(events.texts[i].at("kind"), std::string("rows missed"));
      QCOMPARE(events.texts[i].at("source"), std::string("recorder"));
      QCOMPARE(events.numbers[i].at("tick"), i == 0 ? 121.0 : 130.0);
      QCOMPARE(events.numbers[i].at("value"), i == 0 ? 120.0 : 7.0);
    }
    QCOMPARE(events.texts[2].at("kind"), std::string("ended"));
    QCOMPARE(events.times[0], std::uint64_t{121'000'000});
  }

  void two_runs_have_topics_of_their_own_and_time_goes_on() {
    RunRig rig;
    LogFile log(path(), 1'000);
    for (int i = 0; i < 2; ++i) {
      Recorder recorder(log, {});
      rig.run(0.02, {&recorder});
      log.publish("step", i == 0 ? R"({"force":1})" : R"({"force":2})");
    }
    log.close();
    const McapReader reader(path());
    reader.verify();
    const Topic first(reader, "/main"), second(reader, "/run2/main");
    QCOMPARE(first.numbers.size(), std::size_t{20});
    QCOMPARE(second.numbers.size(), std::size_t{20});
    QCOMPARE(Topic(reader, "/run2/events").texts.size(), std::size_t{2});
    QCOMPARE(first.times.front(), std::uint64_t{1'000});
    QVERIFY(second.times.front() >= first.times.back());
    const Topic published(reader, "/published");
    QCOMPARE(published.texts.size(), std::size_t{2});
    QCOMPARE(published.texts[1].at("name"), std::string("step"));
    QCOMPARE(published.texts[1].at("json"), std::string(R"({"force":2})"));
    std::uint64_t last = 0;
    reader.messages([&](const McapMessage& message) {
      QVERIFY(message.log_time_ns >= last);
      last = message.log_time_ns;
    });
  }

  void a_selection_narrows_the_file_but_keeps_devices_and_events() {
    RunRig rig;
    LogFile log(path(), 0);
    Recorder recorder(log, [](const std::string& port) { return port == "meter.count"; });
    rig.run(0.02, {&recorder});
    log.close();
    const McapReader reader(path());
    const Topic rows(reader, "/main");
    QCOMPARE(rows.numbers[7].at("meter.count"), -7.0);
    QVERIFY(!rows.numbers[7].contains("meter.value"));
    QVERIFY(rows.numbers[7].contains("arm.effort_sent.axis1"));
    QCOMPARE(rows.numbers[7].at("tick"), 7.0);
    QCOMPARE(Topic(reader, "/events").texts.size(), std::size_t{2});
  }

  void attachments_read_back() {
    {
      LogFile log(path(), 0);
      log.attach("wall.lua", "text/x-lua", "return 1");
      log.close();
    }
    const McapReader reader(path());
    QCOMPARE(reader.attachments().size(), std::size_t{1});
    QCOMPARE(reader.read(reader.attachments()[0]).size(), std::size_t{8});
  }

  void a_path_that_takes_nothing_is_refused_with_the_reason_data() {
    QTest::addColumn<QString>("target");
    QTest::newRow("a disk that is full") << "/dev/full";
    QTest::newRow("a folder that is not there") << "/nowhere/at/all.mcap";
  }
  void a_path_that_takes_nothing_is_refused_with_the_reason() {
    QFETCH(QString, target);
    try {
      LogFile log(target.toStdString(), 0);
      Recorder recorder(log, {});
      RunRig().run(0.01, {&recorder});
      log.close();
      QFAIL("nothing was said");
    } catch (const std::runtime_error& error) {
      QVERIFY2(QString(error.what()).contains(target), error.what());
    }
  }

  void a_disk_that_fills_up_is_reported_and_the_run_goes_on() {
    RunRig rig;
    TestSink other;
    RunResult result;
    LogFile log(path(), 0);
    {
      const SizeLimit limit(600'000);
      for (int i = 0; i < 2; ++i) {  // the second begins on a disk that is full
        Recorder recorder(log, {});
        RunOptions options = test::wanted(5.0);
        options.keep_rows = false;  // its file would meet the limit too
        options.sinks = {&recorder, &other};
        result = run(rig.graph, options);
        QCOMPARE(result.lost.size(), std::size_t{1});
        QVERIFY(QString::fromStdString(result.lost[0]).contains("ulimit"));
        QCOMPARE(result.main().loop.ticks, std::int64_t{5000});
      }
      QCOMPARE(other.rows, 10'000);
      QVERIFY_THROWS_EXCEPTION(std::runtime_error, log.close());
    }
    const McapReader reader(path());  // what was written before stays readable
    QVERIFY(!reader.complete());
    QVERIFY(Topic(reader, "/main").numbers.size() >= 500);
  }

  void the_same_seed_writes_the_same_bytes_and_another_does_not() {
    const QByteArray first = log_of_the_laparoscope(path(), 1);
    QVERIFY(first.size() > 100'000);
    QVERIFY(first == log_of_the_laparoscope(path(), 1));
    QVERIFY(first != log_of_the_laparoscope(path(), 2));
  }

 private:
  std::string path() const { return folder_.filePath("log.mcap").toStdString(); }
  QTemporaryDir folder_;
};

QTEST_APPLESS_MAIN(TestLogFile)
#include "tst_log_file.moc"
