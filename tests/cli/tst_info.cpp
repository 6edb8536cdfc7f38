// SPDX-License-Identifier: Apache-2.0
// What `trocar info` finds in a log.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "cli/log_report.hpp"
#include "cli/tick_gaps.hpp"
#include "framework/recording/cdr.hpp"
#include "framework/recording/mcap_writer.hpp"
#include "tests/cli/trocar_process.hpp"
#include "tests/support/mcap_records.hpp"

using namespace trocar;
using namespace trocar::cli;
using namespace trocar::test;

namespace {

const std::vector<Ros2Message> row_messages = {
    {"trocar/Row",
     {{"tick", "int64"},
      {"time", "int64", 0, "[ns] of the slot"},
      {"flags", "int64"},
      {"step_times", "trocar/StepTimes", 0, "[ns] of each component"},
      {"wall", "trocar/NodeWall"}}},
    {"trocar/NodeWall",
     {{"force", "trocar/Wrench", 0, "[N, N m] in device What it gives"},
      {"depth", "float64", 0, "[m] How far in"}}},
    {"trocar/Wrench", {{"force", "trocar/Vector3"}, {"moment", "trocar/Vector3"}}},
    {"trocar/Vector3", {{"x", "float64"}, {"y", "float64"}, {"z", "float64"}}},
    {"trocar/StepTimes", {{"wall", "int64"}}}};

/// 100 rows at 1 kHz; rows 40 to 42 are lost, the loop skipped slot 70.
void write_rows(McapWriter& log) {
  const std::uint16_t schema = log.schema("trocar/Row", "ros2msg", ros2_schema_text(row_messages));
  const std::uint16_t channel = log.channel("/main", schema, "cdr");
  std::vector<std::byte> bytes;
  for (std::int64_t tick = 0; tick < 104; ++tick) {
    if ((tick >= 40 && tick <= 42) || tick == 70) continue;
    CdrWriter row(bytes);
    row.number(tick);
    row.number(tick * 1'000'000);
    row.number(std::int64_t{tick == 71 ? 4 : 0});
    row.number(std::int64_t{0});
    for (int i = 0; i < 6; ++i) row.number(i == 2 ? -0.5 * static_cast<double>(tick) : 0.0);
    row.number(1e-3);
    const auto time = static_cast<std::uint64_t>(tick) * 1'000'000;
    log.message(channel, static_cast<std::uint32_t>(tick), time, time, bytes);
  }
}

void write_events(McapWriter& log) {
  const std::uint16_t schema = log.schema(
      "trocar/Event", "ros2msg",
      "int64 tick\nint64 time\nstring kind\nstring source\nstring detail\nfloat64 value\n"
      "float64 limit\n");
  const std::uint16_t channel = log.channel("/events", schema, "cdr");
  std::vector<std::byte> bytes;
  CdrWriter event(bytes);
  event.number(std::int64_t{71});
  event.number(std::int64_t{71'000'000});
  event.string("gate");
  event.string("device");
  event.string("effort was limited");
  event.number(250.0);
  event.number(200.0);
  log.message(channel, 0, 71'000'000, 71'000'000, bytes);
}

void write_published(McapWriter& log) {
  const std::uint16_t schema =
      log.schema("trocar/Published", "ros2msg", "string name\nstring json\n");
  const std::uint16_t channel = log.channel("/published", schema, "cdr");
  for (const char* json : {R"({"axis":"x","slope":4.85})", R"({"axis":"y","slope":5.78})", "{no"}) {
    std::vector<std::byte> bytes;
    CdrWriter row(bytes);
    row.string("table1");
    row.string(json);
    log.message(channel, 0, 103'000'000, 103'000'000, bytes);
  }
}

}  // namespace

class TestInfo : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  std::string path(const char* name) const { return folder_.filePath(name).toStdString(); }

 private Q_SLOTS:
  void initTestCase() {
    McapWriter log(path("log.mcap"));
    write_rows(log);
    write_events(log);
    write_published(log);
    log.attachment("wall.lua", "text/x-lua", 0, 0, span_of("trocar.Wall {}"));
    const std::uint16_t alien =
        log.channel("/camera", log.schema("Image", "protobuf", "?"), "protobuf");
    log.message(alien, 0, 0, 0, span_of("picture"));
    log.close();
  }

  void rows_and_what_is_missing_are_counted() {
    const LogSummary log = summarize_log(path("log.mcap"), false);
    QVERIFY(log.complete());
    const LogSummary::Channel& rows = log.channels.at(0);
    QVERIFY(rows.rows);
    QCOMPARE(rows.messages, quint64(100));
    QCOMPARE(rows.ticks.rows_lost(), quint64(3));
    QCOMPARE(rows.ticks.gaps(), quint64(1));
    QCOMPARE(*rows.ticks.first_gap(), qint64(39));
    QCOMPARE(rows.ticks.slots_skipped(), quint64(1));
    QVERIFY(std::abs(rows.rate() - 1000.0) < 1e-6);
    QVERIFY(std::abs(log.duration() - 0.104) < 1e-9);
    QVERIFY(!log.channels.at(3).decoded);
    QVERIFY(log.channels.at(3).problem.find("not ros2msg") != std::string::npos);
  }

  void units_come_from_the_schema() {
    const LogSummary log = summarize_log(path("log.mcap"), false);
    std::map<std::string, std::string> units;
    for (const LogSignal& signal : log.channels.at(0).signal_list) units[signal.name] = signal.unit;
    QCOMPARE(units.at("wall.force.force.z"), std::string("N"));
    QCOMPARE(units.at("wall.force.moment.x"), std::string("N m"));
    QCOMPARE(units.at("wall.depth"), std::string("m"));
    QCOMPARE(units.at("step_times.wall"), std::string("ns"));
    QCOMPARE(units.at("tick"), std::string());
  }

  void values_are_read_on_request() {
    const LogSummary log = summarize_log(path("log.mcap"), true);
    for (const LogSignal& signal : log.channels.at(0).signal_list) {
      if (signal.name != "wall.force.force.z") continue;
      QCOMPARE(signal.count, quint64(100));
      QCOMPARE(signal.first, 0.0);
      QCOMPARE(signal.last, -51.5);
      QCOMPARE(signal.min, -51.5);
      QCOMPARE(signal.max, 0.0);
      return;
    }
    QFAIL("the signal is not there");
  }

  void the_text_says_it_all_within_80_columns() {
    const LogSummary log = summarize_log(path("log.mcap"), true);
    const QString text = QString::fromStdString(log_text(log, std::nullopt));
    for (const char* part :
         {"  Complete    yes\n", "  Duration    0.104 s\n",
          "  1 kHz  trocar/Row: 3 rows lost in 1 gap, the first", "1 slot skipped by the loop",
          "only counted: its schema is not ros2msg",
          "  0.071 s  tick 71  gate  device: effort was limited, value 250 (limit 200)\n",
          "Published: table1 (3 rows)\n  axis = x, slope = 4.85\n  axis = y, slope = 5.78\n  {no\n",
          "  wall.lua  14 B  text/x-lua\n", "  wall.force  6 numbers  N, N m\n",
          "  wall.depth             m\n"})
      QVERIFY2(text.contains(QString(part)), qPrintable(part + ("\nis not in\n" + text)));
    QVERIFY(!text.contains("step_times"));
    const QString values = QString::fromStdString(log_text(log, "force.force"));
    QVERIFY2(values.contains("-51.5") && !values.contains("depth"), qPrintable(values));
    for (const QString& line : (text + values).split('\n'))
      QVERIFY2(line.size() <= 80 || line.contains(folder_.path()), qPrintable(line));
  }

  void the_json_says_it_all() {
    const Ran ran =
        run_trocar({"info", folder_.filePath("log.mcap"), "--json", "--signals", "wall.*"});
    QCOMPARE(ran.status, 0);
    const auto json = nlohmann::json::parse(ran.out.toStdString());
    QCOMPARE(json["channels"][0]["rows_lost"].get<int>(), 3);
    QCOMPARE(json["channels"][0]["signals"].size(), std::size_t(7));
    QCOMPARE(json["channels"][0]["signals"][2]["min"].get<double>(), -51.5);
    QCOMPARE(json["events"][0]["kind"].get<std::string>(), std::string("gate"));
    QCOMPARE(json["published"]["table1"][1]["slope"].get<double>(), 5.78);
    QCOMPARE(json["attachments"][0]["bytes"].get<int>(), 14);
    QVERIFY(json["complete"].get<bool>() && json["size_ratio"].get<double>() > 1.0);
  }

  void a_log_that_was_cut_off_says_so() {
    const QByteArray whole = read_bytes(path("log.mcap"));
    write_bytes(path("cut.mcap"), whole.left(whole.size() - 20));
    const Ran ran = run_trocar({"info", folder_.filePath("cut.mcap")});
    QCOMPARE(ran.status, 0);
    QVERIFY2(ran.out.contains("Complete    no: ") && ran.out.contains("100 rows"), ran.out);
  }

  void what_is_no_sound_log_is_refused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("message");
    QByteArray damaged = read_bytes(path("log.mcap"));
    damaged[damaged.indexOf("effort was limited")] = 'E';
    QTest::newRow("a byte that changed") << damaged << QByteArray("checksum of the chunk is wrong");
    QTest::newRow("an empty file") << QByteArray() << QByteArray("trocar: info: ");
    QTest::newRow("something else") << QByteArray(1000, 'x') << QByteArray("trocar: info: ");
  }
  void what_is_no_sound_log_is_refused() {
    QFETCH(QByteArray, bytes);
    QFETCH(QByteArray, message);
    write_bytes(path("bad.mcap"), bytes);
    const Ran ran = run_trocar({"info", folder_.filePath("bad.mcap")});
    QCOMPARE(ran.status, 1);
    QVERIFY2(ran.err.contains(message), ran.err);
    QCOMPARE(ran.out, QByteArray());
  }

  void messages_that_do_not_fit_their_schema_are_named() {
    {
      McapWriter log(path("short.mcap"));
      const std::uint16_t schema = log.schema("a/B", "ros2msg", "float64 x\n");
      log.message(log.channel("/b", schema, "cdr"), 0, 0, 0, span_of(QByteArray("\0\1\0\0xx", 6)));
    }
    const Ran ran = run_trocar({"info", folder_.filePath("short.mcap"), "--signals"});
    QCOMPARE(ran.status, 1);
    QVERIFY2(ran.out.contains("message 1: CDR"), ran.out);
  }

  void a_pattern_that_means_nothing_is_refused() {
    const Ran ran = run_trocar({"info", folder_.filePath("log.mcap"), "--signals", "wall.dept_h"});
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.contains("did you mean \"wall.depth\"?"), ran.err);
  }

  void rows_of_a_slow_group_are_not_lost() {
    TickGaps ticks;
    for (const std::int64_t tick : {2, 6, 10, 18, 22, 2, 6})
      ticks.add(tick, tick * 1'000'000, false);
    QCOMPARE(ticks.rows_lost(), quint64(1));
    QCOMPARE(ticks.runs(), quint64(2));
    QVERIFY(std::abs(ticks.rate() - 250.0) < 1e-6);
  }
};

QTEST_GUILESS_MAIN(TestInfo)
#include "tst_info.moc"
