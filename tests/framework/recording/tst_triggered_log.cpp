// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/triggered_log.hpp"

#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "tests/support/log_topic.hpp"
#include "tests/support/mcap_records.hpp"
#include "tests/support/run_rig.hpp"
#include "tests/support/size_limit.hpp"

using namespace trocar;
using test::SizeLimit;
using test::Topic;

namespace {

/// Triggers at the ticks that a test names.
class TickTrigger final : public Trigger {
 public:
  TickTrigger(Window window, std::set<std::int64_t> ticks)
      : window_(window), ticks_(std::move(ticks)) {}
  Window begin(const std::vector<RowLayout>&, const WiredGraph&) override { return window_; }
  bool row(std::size_t, std::span<const std::byte> row) override {
    tick_ = header_of(row).tick;
    return ticks_.contains(tick_);
  }
  std::string cause() const override { return "tick " + std::to_string(tick_); }

 private:
  Window window_;
  std::set<std::int64_t> ticks_;
  std::int64_t tick_ = 0;
};

}  // namespace

class TestTriggeredLog : public QObject {
  Q_OBJECT

  struct Wrote {
    std::vector<TriggeredFile> files;
    std::vector<std::string> troubles;
    std::uint64_t refused = 0;
  };

 private Q_SLOTS:
  void what_is_written_begins_before_the_trigger_and_ends_after_it_data() {
    QTest::addColumn<double>("before");
    QTest::addColumn<double>("after");
    QTest::addColumn<QList<int>>("ticks");  // of triggers
    QTest::addColumn<QList<int>>("from");   // tick of the first row of each file
    QTest::addColumn<QList<int>>("to");     // and of the last
    const auto row = [](const char* name, double before, double after, QList<int> ticks,
                        QList<int> from, QList<int> to) {
      QTest::newRow(name) << before << after << ticks << from << to;
    };
    row("one trigger", 0.05, 0.02, {100}, {50}, {120});
    row("one before there was as much to keep", 0.05, 0.02, {10}, {0}, {30});
    row("one near the end of the run", 0.05, 0.02, {290}, {240}, {299});
    row("nothing before", 0.0, 0.02, {100}, {100}, {120});
    row("nothing after", 0.05, 0.0, {100}, {50}, {100});
    row("two apart have a file each", 0.02, 0.01, {50, 150}, {30, 130}, {60, 160});
    row("two whose times overlap share one", 0.05, 0.02, {100, 110}, {50}, {130});
    row("so they do when the first was over", 0.05, 0.02, {100, 160}, {50}, {180});
    row("they touch", 0.05, 0.02, {100, 170}, {50}, {190});
    row("they just do not", 0.05, 0.02, {100, 172}, {50, 122}, {120, 192});
    row("a level", 0.01, 0.01, {100, 101, 102, 103}, {90}, {113});
  }
  void what_is_written_begins_before_the_trigger_and_ends_after_it() {
    QFETCH(double, before);
    QFETCH(double, after);
    QFETCH(QList<int>, ticks);
    QFETCH(QList<int>, from);
    QFETCH(QList<int>, to);
    const Wrote wrote = run({before, after}, {ticks.begin(), ticks.end()});
    QVERIFY(wrote.troubles.empty());
    QCOMPARE(wrote.files.size(), static_cast<std::size_t>(from.size()));
    for (qsizetype i = 0; i < from.size(); ++i) {
      const TriggeredFile& file = wrote.files[static_cast<std::size_t>(i)];
      const McapReader log(file.path);
      QVERIFY(log.complete());
      log.verify();
      const Topic rows(log, "/main");
      QCOMPARE(rows.numbers.size(), static_cast<std::size_t>(to[i] - from[i] + 1));
      QCOMPARE(file.rows, rows.numbers.size());
      for (std::size_t n = 0; n < rows.numbers.size(); ++n) {
        const double tick = from[i] + static_cast<double>(n);
        QCOMPARE(rows.numbers[n].at("tick"), tick);
        QCOMPARE(rows.numbers[n].at("meter.value"), 2.0 + tick);
        QCOMPARE(rows.times[n], static_cast<std::uint64_t>(tick) * 1'000'000);
      }
      QCOMPARE(file.from, 1e-3 * from[i]);
      QCOMPARE(file.to, 1e-3 * to[i]);
    }
  }

  void events_stand_where_they_happened() {
    const Wrote wrote = run({0.05, 0.02}, {200});
    const Topic events(McapReader(wrote.files.at(0).path), "/events");
    std::vector<double> ticks;
    for (const auto& event : events.numbers) ticks.push_back(event.at("tick"));
    QCOMPARE(ticks, (std::vector{150.0, 180.0, 210.0}));  // an edit each 30 ticks
    QCOMPARE(events.texts[0].at("kind"), std::string("edit"));
  }

  void the_cause_and_what_explains_it_are_attached() {
    const Wrote wrote = run({0.05, 0.02}, {100, 110});
    QCOMPARE(wrote.files.at(0).cause, std::string("tick 100"));
    QCOMPARE(wrote.files.at(0).writer, std::string("black box"));
    const McapReader log(wrote.files[0].path);
    QCOMPARE(log.attachments().size(), std::size_t{2});
    QCOMPARE(log.attachments()[0].name, std::string("wall.lua"));
    QCOMPARE(log.attachments()[1].name, std::string("cause.txt"));
    const auto text = log.read(log.attachments()[1]);
    QCOMPARE(std::string(reinterpret_cast<const char*>(text.data()), text.size()),
             std::string("tick 100\n"));
  }

  void without_a_trigger_there_is_no_file() {
    const Wrote wrote = run({0.05, 0.02}, {});
    QVERIFY(wrote.files.empty() && wrote.troubles.empty());
  }

  void there_are_only_so_many_files() {
    const Wrote wrote = run({0.01, 0.01}, {30, 80, 130, 180, 185, 230}, {.most_files = 2});
    QCOMPARE(wrote.files.size(), std::size_t{2});
    QCOMPARE(wrote.refused, std::uint64_t{3});  // 180 and 185 would have shared one
  }

  void the_same_run_leaves_the_same_bytes() {
    const QByteArray first = test::read_bytes(run({0.05, 0.02}, {100}).files.at(0).path);
    QVERIFY(first.size() > 10'000);
    QVERIFY(first == test::read_bytes(run({0.05, 0.02}, {100}).files.at(0).path));
  }

  void a_disk_that_is_full_costs_the_file_and_not_the_run_data() {
    QTest::addColumn<QString>("target");
    QTest::addColumn<int>("bytes");
    QTest::newRow("from the beginning") << "/dev/full" << 0;
    QTest::newRow("a folder that is not there") << "/nowhere/at/all.mcap" << 0;
    QTest::newRow("in the middle") << "" << 30'000;
  }
  void a_disk_that_is_full_costs_the_file_and_not_the_run() {
    QFETCH(QString, target);
    QFETCH(int, bytes);
    std::optional<SizeLimit> limit;
    if (bytes > 0) limit.emplace(static_cast<rlim_t>(bytes));
    TriggeredLog::Options options;
    const std::string path = target.isEmpty() ? file(0) : target.toStdString();
    options.next_path = [path] { return path; };
    const Wrote wrote = run({0.05, 0.2}, {60}, options);
    QCOMPARE(wrote.troubles.size(), std::size_t{1});
    const QString said = QString::fromStdString(wrote.troubles[0]);
    QVERIFY2(said.startsWith("black box: cannot ") && said.contains(path.c_str()),
             qPrintable(said));
  }

  void a_reader_that_fell_behind_says_so_in_the_file() {
    RigOfRows rig;
    TickTrigger trigger({0.05, 0.02}, {100});
    TriggeredLog log(trigger, options());
    log.begin(rig.layouts, *rig.wired);
    for (std::int64_t tick = 0; tick < 200; ++tick) {
      if (tick == 80 || tick == 110) log.missed(7);
      log.row(0, rig.row(tick));
    }
    log.end();
    const Topic events(McapReader(log.files().at(0).path), "/events");
    QCOMPARE(events.texts.size(), std::size_t{2});
    for (std::size_t i = 0; i < 2; ++i) {
      QCOMPARE(events.texts[i].at("kind"), std::string("rows missed"));
      QCOMPARE(events.texts[i].at("source"), std::string("black box"));
      QCOMPARE(events.numbers[i].at("value"), 7.0);
      QCOMPARE(events.numbers[i].at("tick"), i == 0 ? 80.0 : 110.0);
    }
  }

  void what_takes_too_much_memory_is_refused_with_what_is_possible() {
    RigOfRows rig;
    TickTrigger trigger({60.0, 0.0}, {});
    TriggeredLog::Options small = options();
    small.most_memory = std::size_t{2} << 20;
    TriggeredLog log(trigger, small);
    try {
      log.begin(rig.layouts, *rig.wired);
      QFAIL("it was taken");
    } catch (const std::runtime_error& error) {
      QVERIFY2(QString(error.what()).contains(", 2 MiB are possible"), error.what());
    }
  }

 private:
  /// Rows without a run.
  struct RigOfRows {
    std::span<const std::byte> row(std::int64_t tick) {
      layouts[0].capture({.tick = tick, .time = tick * 1'000'000}, times, wired->main().memory(),
                         bytes);
      return bytes;
    }
    test::RunRig run;
    std::unique_ptr<WiredGraph> wired = wire(run.graph, {});
    std::vector<RowLayout> layouts = layouts_of(*wired);
    std::vector<std::int64_t> times = std::vector<std::int64_t>(wired->main().schedule().size());
    std::vector<std::byte> bytes = std::vector<std::byte>(layouts[0].size());
  };

  std::string file(int number) const {
    return folder_.filePath(QString("%1.mcap").arg(number)).toStdString();
  }
  TriggeredLog::Options options() {
    TriggeredLog::Options options;
    options.name = "black box";
    options.attachments = {{"wall.lua", "text/x-lua", "return 1"}};
    options.next_path = [this] { return file(next_++); };
    return options;
  }

  /// 300 ticks at 1 kHz with an edit each 30.
  Wrote run(Trigger::Window window, std::set<std::int64_t> ticks,
            const TriggeredLog::Options& wanted = {}) {
    TickTrigger trigger(window, std::move(ticks));
    TriggeredLog::Options all = options();
    all.most_files = wanted.most_files;
    if (wanted.next_path) all.next_path = wanted.next_path;
    TriggeredLog log(trigger, all);
    test::RunRig rig;
    std::vector<Edit> edits;
    for (int i = 1; i < 10; ++i) edits.push_back(test::edit_of("meter.gain", "2 N", 0.03 * i));
    RunOptions options = test::wanted(0.3);
    options.keep_rows = false;  // its file would meet a limit too
    options.sinks = {&log};
    options.edits = edits;
    const RunResult result = trocar::run(rig.graph, options);
    Wrote wrote{log.files(), log.troubles(), log.refused()};
    if (!result.lost.empty() || result.main().loop.ticks != 300)
      wrote.troubles.push_back("the run");
    return wrote;
  }

  QTemporaryDir folder_;
  int next_ = 0;
};

QTEST_APPLESS_MAIN(TestTriggeredLog)
#include "tst_triggered_log.moc"
