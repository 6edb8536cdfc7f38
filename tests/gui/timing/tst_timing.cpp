// SPDX-License-Identifier: Apache-2.0
// What is told of a loop's times is what its rows say.
#include <QAbstractItemModelTester>
#include <QApplication>
#include <QPushButton>
#include <cstring>
#include <random>

#include "framework/recording/row_layout.hpp"
#include "gui/operate/operator.hpp"
#include "gui/pages/timing_page.hpp"
#include "tests/gui/log_rig.hpp"
#include "tests/gui/pictures.hpp"

using namespace trocar;
using namespace trocar::gui;
using trocar::test::colours_in;
using trocar::test::LogRig;
using trocar::test::picture_of;

namespace {

/// A run of one thread at 1 kHz with two components.
class TimingRig {
 public:
  TimingRig() {
    const std::vector<Ros2Field> steps = {{"wall", "int64", 0, "[ns]"},
                                          {"left_tool", "int64", 0, "[ns]"}};
    const std::vector<Ros2Field> row = {
        {"tick", "int64", 0, {}},         {"time", "int64", 0, "[ns]"},
        {"lateness", "int64", 0, "[ns]"}, {"duration", "int64", 0, "[ns]"},
        {"flags", "int64", 0, {}},        {"step_times", "trocar/StepTimes", 0, "[ns]"}};
    schema_ = ros2_schema_text({{"trocar/Row", row, {}}, {"trocar/StepTimes", steps, {}}});
    begin();
  }

  void begin() {
    std::vector<std::unique_ptr<Track>> tracks;
    tracks.push_back(
        std::make_unique<Track>("main", "trocar/Row", schema_, 0.001, 60.0, std::size_t{64} << 20));
    track = tracks.front().get();
    store.begin_run(std::move(tracks));
  }
  struct Times {
    std::int64_t lateness = 0, duration = 0, flags = 0, wall = 0, tool = 0;  // [ns]
  };
  void add(std::int64_t tick, const Times& times) {
    const std::int64_t numbers[] = {tick,        tick * 1'000'000, times.lateness, times.duration,
                                    times.flags, times.wall,       times.tool};
    track->add(std::as_bytes(std::span(numbers)));
  }
  Sources sources() { return {.data = store}; }

  DataStore store;
  Track* track = nullptr;

 private:
  std::string schema_;
};

double share_of_sorted(std::vector<std::int64_t> samples, double share) {
  std::sort(samples.begin(), samples.end());
  const auto n = static_cast<std::size_t>(std::ceil(share * static_cast<double>(samples.size())));
  return static_cast<double>(samples[std::max<std::size_t>(n, 1) - 1]);
}

}  // namespace

class TestTiming : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void percentiles_are_those_of_the_sorted_samples_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("spread");
    QTest::newRow("one tick") << 1 << 0.5;
    QTest::newRow("a few ticks") << 10 << 0.5;
    QTest::newRow("many ticks, much alike") << 20000 << 0.1;
    QTest::newRow("many ticks, from nanoseconds to milliseconds") << 20000 << 3.0;
  }
  void percentiles_are_those_of_the_sorted_samples() {
    QFETCH(int, count);
    QFETCH(double, spread);
    std::mt19937 random(7);
    std::lognormal_distribution<double> times(std::log(20'000.0), spread);
    TimingRig rig;
    std::vector<std::int64_t> late, wall, taken;
    for (int tick = 0; tick < count; ++tick) {
      const auto one = [&] { return std::llround(times(random)) + 1; };
      const TimingRig::Times row{.lateness = one(), .duration = one(), .wall = one()};
      rig.add(tick, row);
      late.push_back(row.lateness);
      wall.push_back(row.wall);
      if (tick > 0) taken.push_back(row.duration);  // of the tick before
    }
    ThreadTiming timing(*rig.track, 0.0);
    while (!timing.take(999)) continue;
    QCOMPARE(timing.ticks(), static_cast<std::uint64_t>(count));
    QCOMPARE(timing.duration().count(), static_cast<std::uint64_t>(taken.size()));
    const auto near = [](const TimingHistogram& histogram, const std::vector<std::int64_t>& all) {
      bool same = histogram.max() == *std::max_element(all.begin(), all.end());
      for (const double share : {0.5, 0.9, 0.99, 0.999}) {
        const double exact = share_of_sorted(all, share);
        const auto found = static_cast<double>(histogram.percentile(share));
        same = same && found >= exact && found <= 1.07 * exact;
      }
      return same;
    };
    QVERIFY(near(timing.lateness(), late));
    QVERIFY(near(timing.components()[0].steps, wall));
    if (!taken.empty()) QVERIFY(near(timing.duration(), taken));
    QCOMPARE(timing.components()[1].steps.count(), std::uint64_t{0});
  }

  void missed_slots_and_missing_rows_are_told_apart() {
    TimingRig rig;
    const auto usual = TimingRig::Times{.lateness = 9000, .duration = 20000, .wall = 5000};
    for (int tick = 0; tick < 100; ++tick) rig.add(tick, usual);
    rig.add(103, {.lateness = 9000, .duration = 3'500'000, .flags = 4});  // skipped 3
    for (int tick = 104; tick < 200; ++tick) rig.add(tick, usual);
    for (int tick = 205; tick < 300; ++tick) rig.add(tick, usual);  // 5 rows did not come
    TimingModel model(rig.sources());
    QVERIFY(model.refresh());
    const ThreadTiming& thread = *model.threads().front();
    QCOMPARE(thread.missed_slots(), std::uint64_t{3});
    QCOMPARE(thread.missing_rows(), std::uint64_t{5});
    QCOMPARE(thread.overloads(), std::uint64_t{1});
    QVERIFY(std::abs(thread.period() - 0.001) < 1e-12);
    QVERIFY(std::abs(thread.least_margin() + 2'500'000.0) < 1.0);
    CellTable table(TimingModel::thread_header());
    QAbstractItemModelTester tester(&table);
    table.show(model.thread_rows());
    QCOMPARE(table.index(0, 1).data().toString(), QString("1000 Hz"));
    QCOMPARE(table.index(0, 9).data().toString(), QString("-2.50 ms"));
    QVERIFY(table.index(0, 9).data(CellTable::warning_role).toBool());
    QCOMPARE(table.index(0, 10).data().toString(), QString("3"));
    QCOMPARE(model.notice(), QString());
  }

  void what_is_shown_is_what_is_counted() {
    TimingRig rig;
    for (int tick = 0; tick < 1000; ++tick) rig.add(tick, {.lateness = 1000 * (tick + 1)});
    TimingModel model(rig.sources());
    model.refresh();
    const ThreadTiming& thread = *model.threads().front();
    QCOMPARE(thread.lateness().max(), std::int64_t{1'000'000});
    rig.store.set_view_end(0.4995);  // playback goes back
    model.refresh();
    QCOMPARE(thread.ticks(), std::uint64_t{500});
    QCOMPARE(thread.lateness().max(), std::int64_t{500'000});
    model.forget();
    QCOMPARE(thread.ticks(), std::uint64_t{0});
    rig.store.set_view_end(std::nullopt);
    model.refresh();
    QCOMPARE(thread.ticks(), std::uint64_t{500});
    QCOMPARE(thread.missing_rows(), std::uint64_t{0});
    rig.begin();  // another run
    model.refresh();
    QCOMPARE(model.threads().front()->ticks(), std::uint64_t{0});
    QCOMPARE(model.notice(), QString("No rows yet."));
  }

  void the_outline_has_every_sample() {
    TimingHistogram histogram;
    std::mt19937 random(3);
    std::lognormal_distribution<double> times(std::log(20'000.0), 1.5);
    for (int i = 0; i < 5000; ++i) histogram.add(std::llround(times(random)));
    double sum = 0.0, before = 0.0;
    for (const HistogramPlot::Step& step : HistogramPlot::steps_of(histogram)) {
      QVERIFY(step.time > before);
      before = step.time;
      sum += step.count;
    }
    QCOMPARE(sum, 5000.0);
    QVERIFY(before * 1e3 >= static_cast<double>(histogram.max()));
    QVERIFY(HistogramPlot::steps_of({}).empty());
  }

  void components_are_sorted_by_what_they_cost() {
    TimingRig rig;
    for (int tick = 0; tick < 500; ++tick)
      rig.add(tick, {.lateness = 10'000, .duration = 30'000, .wall = 900, .tool = 12'000});
    Operator operators(rig.sources());
    TimingPage page(operators);
    page.refresh();
    auto* table = page.findChild<QTableView*>("component_times");
    QAbstractItemModelTester tester(table->model());
    const auto cell = [&](int row, int column) {
      return table->model()->index(row, column).data().toString();
    };
    QCOMPARE(table->model()->rowCount(), 2);
    QCOMPARE(cell(0, 0), QString("left_tool"));
    QCOMPARE(cell(0, 4), QString("12.0 µs"));
    QCOMPARE(cell(0, 5), QString("1.2 %"));
    QCOMPARE(cell(1, 4), QString("900 ns"));  // less, though 900 is the greater number
    table->sortByColumn(4, Qt::AscendingOrder);
    QCOMPARE(cell(0, 0), QString("wall"));
    QTest::mouseClick(page.findChild<QPushButton*>("count_from_now"), Qt::LeftButton);
    QCOMPARE(cell(0, 6), QString("0"));
  }

  void virtual_time_says_that_its_times_are_none() {
    LogRig rig(
        "local c = trocar.Constant { value = '1 N' }\ntrocar.Scale { input = c.value, factor = 2 "
        "}\n",
        {}, 0.1);
    QVERIFY2(rig.findings.isEmpty(), qPrintable(rig.findings.join('\n')));
    Operator operators(rig.sources());
    TimingPage page(operators);
    page.refresh();
    QVERIFY(page.model().notice().startsWith("Virtual time"));
    auto* table = page.findChild<QTableView*>("component_times");
    QCOMPARE(table->model()->rowCount(), 2);
    QCOMPARE(table->model()->index(0, 4).data().toString(), QString("–"));
  }

  void a_run_in_real_time_is_seen() {
    QFile script(TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua");
    QVERIFY(script.open(QFile::ReadOnly));
    LogRig rig(script.readAll(), {}, 0.5, ClockKind::realtime);
    QVERIFY2(rig.findings.isEmpty(), qPrintable(rig.findings.join('\n')));
    Operator operators(rig.sources());
    for (const Theme& theme : {Theme::dark_one(), Theme::light()}) {
      QApplication::setPalette(theme.palette());
      TimingPage page(operators);
      page.set_theme(theme);
      page.resize(1260, 600);
      page.show();
      page.refresh();
      QVERIFY(page.model().notice().isEmpty());
      const ThreadTiming& thread = *page.model().threads().front();
      QVERIFY(thread.ticks() > 10);
      QCOMPARE(thread.ticks() + thread.missed_slots(), std::uint64_t{500});
      QVERIFY(thread.duration().max() > 0);
      QVERIFY(page.findChild<MarginPlot*>("margin_plot")->least() < 100.0);
      QTest::qWait(0);
      QVERIFY(colours_in(picture_of(page, theme.dark ? "timing_dark" : "timing_light")) > 50);
    }
  }
};

QTEST_MAIN(TestTiming)
#include "tst_timing.moc"
