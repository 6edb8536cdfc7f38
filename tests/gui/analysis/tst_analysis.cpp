// SPDX-License-Identifier: Apache-2.0
// What is found in signals, without a window: triggers, statistics, tables, layouts.
#include <QAbstractItemModelTester>
#include <QMimeData>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "gui/analysis/plot_layout.hpp"
#include "gui/analysis/range_statistics.hpp"
#include "gui/analysis/signal_tree.hpp"
#include "gui/analysis/trigger.hpp"
#include "gui/analysis/value_table.hpp"
#include "gui/analysis/visible_csv.hpp"
#include "tests/gui/track_rig.hpp"

using namespace trocar;
using namespace trocar::gui;
using trocar::test::TrackRig;

using When = TriggerSettings::When;
using TriggerMode = TriggerSettings::Mode;
using Steps = QList<double>;

namespace {

constexpr double rate = 1000.0;  // [Hz]

/// Feeds what `shape(tick)` says up to tick `to`.
void feed(TrackRig& rig, std::int64_t& fed, std::int64_t to,
          const std::function<double(std::int64_t)>& shape) {
  rig.feed(fed, to, rate, [&](std::size_t, std::int64_t tick) { return shape(tick); });
  fed = to;
}

double spike_at(std::int64_t tick, std::int64_t at) {
  return tick == at ? 5.0 : 0.0;
}

QString complaint(const QByteArray& text) {
  try {
    read_layout(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace

class TestAnalysis : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // --- trigger ---
  void a_trigger_fires_where_its_condition_says_data() {
    QTest::addColumn<When>("when");
    QTest::addColumn<double>("hysteresis");
    QTest::addColumn<Steps>("samples");
    QTest::addColumn<int>("expected");  // sample that triggers, −1: none
    const double nan = std::nan("");
    QTest::newRow("rises") << When::rises << 0.0 << Steps{0, 0.5, 1.5, 2} << 2;
    QTest::newRow("rises to just the level") << When::rises << 0.0 << Steps{0, 1, 2} << 1;
    QTest::newRow("is above from the start: no edge") << When::rises << 0.0 << Steps{2, 3, 2} << -1;
    QTest::newRow("falls") << When::falls << 0.0 << Steps{2, 3, 0.5, 0} << 2;
    QTest::newRow("rising is not falling") << When::falls << 0.0 << Steps{0, 0.5, 3} << -1;
    QTest::newRow("crosses upwards") << When::crosses << 0.0 << Steps{0, 2} << 1;
    QTest::newRow("crosses downwards") << When::crosses << 0.0 << Steps{2, 0} << 1;
    QTest::newRow("is above") << When::above << 0.0 << Steps{1, 1, 1.01} << 2;
    QTest::newRow("is above at once") << When::above << 0.0 << Steps{3} << 0;
    QTest::newRow("is below") << When::below << 0.0 << Steps{1, 0.9} << 1;
    QTest::newRow("noise within the hysteresis") << When::rises << 0.5 << Steps{2, 0.7, 1.2} << -1;
    QTest::newRow("from beyond the hysteresis") << When::rises << 0.5 << Steps{2, 0.5, 1.2} << 2;
    QTest::newRow("no number is no value") << When::rises << 0.0 << Steps{nan, 2, 0, nan, 2} << 4;
    QTest::newRow("a number that is none is not above") << When::above << 0.0 << Steps{nan} << -1;
  }
  void a_trigger_fires_where_its_condition_says() {
    QFETCH(When, when);
    QFETCH(double, hysteresis);
    QFETCH(Steps, samples);
    QFETCH(int, expected);
    TrackRig rig({"force"});
    Trigger trigger;
    trigger.arm(rig.store, {.signal = "force",
                            .when = when,
                            .mode = TriggerMode::single,
                            .level = 1.0,
                            .hysteresis = hysteresis,
                            .before = 0.1,
                            .after = 0.01});
    std::int64_t fed = 0;
    feed(rig, fed, samples.size(), [&](std::int64_t tick) { return samples[tick]; });
    trigger.search(rig.store);
    // What follows is no edge and no level of its own.
    feed(rig, fed, fed + 50, [&](std::int64_t) { return 1.0; });
    const bool once_more =
        expected < 0 && (when == When::rises || when == When::falls || when == When::crosses);
    if (!once_more) trigger.search(rig.store);
    QCOMPARE(trigger.shot().has_value(), expected >= 0);
    if (expected >= 0) QCOMPARE(trigger.shot()->at, expected / rate);
  }

  void a_spike_of_one_tick_triggers_wherever_batches_end() {
    for (const std::int64_t size : {1, 7, 100, 3000}) {
      TrackRig rig({"force"});
      Trigger trigger;
      trigger.arm(rig.store, {.signal = "force", .level = 3.0, .before = 0.2, .after = 0.3});
      for (std::int64_t fed = 0; fed < 2000;) {
        feed(rig, fed, fed + size, [](std::int64_t tick) { return spike_at(tick, 1234); });
        trigger.search(rig.store);
      }
      QVERIFY(trigger.shot().has_value());
      QCOMPARE(*trigger.shot(), (Shot{1.234, 0.2, 0.3}));
      QCOMPARE(trigger.count(), std::uint64_t{1});
    }
  }

  void a_shot_waits_for_the_time_after_it() {
    TrackRig rig({"force"});
    Trigger trigger;
    trigger.arm(rig.store, {.signal = "force", .level = 3.0, .before = 0.1, .after = 0.5});
    std::int64_t fed = 0;
    const auto shape = [](std::int64_t tick) { return spike_at(tick, 100); };
    feed(rig, fed, 100, shape);
    QVERIFY(!trigger.search(rig.store));
    QCOMPARE(trigger.state(), Trigger::State::armed);
    feed(rig, fed, 600, shape);
    QVERIFY(!trigger.search(rig.store));
    QCOMPARE(trigger.state(), Trigger::State::filling);
    QVERIFY(!trigger.shot());
    feed(rig, fed, 601, shape);
    QVERIFY(trigger.search(rig.store));
    QCOMPARE(trigger.shot()->at, 0.1);
  }

  void modes_differ_in_what_follows_a_shot_data() {
    QTest::addColumn<TriggerMode>("mode");
    QTest::addColumn<double>("second");  // [s] of what is shown after a second spike, −1: nothing
    QTest::addColumn<double>("later");   // and long after it
    QTest::newRow("single") << TriggerMode::single << 0.5 << 0.5;
    QTest::newRow("normal") << TriggerMode::normal << 1.5 << 1.5;
    QTest::newRow("auto") << TriggerMode::automatic << 1.5 << -1.0;
  }
  void modes_differ_in_what_follows_a_shot() {
    QFETCH(TriggerMode, mode);
    QFETCH(double, second);
    QFETCH(double, later);
    TrackRig rig({"force"});
    Trigger trigger;
    trigger.arm(rig.store,
                {.signal = "force", .mode = mode, .level = 3.0, .before = 0.1, .after = 0.2});
    std::int64_t fed = 0;
    // The spike at 0.6 s lies within the first shot.
    const auto shape = [](std::int64_t tick) {
      return tick == 500 || tick == 600 || tick == 1500 ? 5.0 : 0.0;
    };
    const auto shown = [&] { return trigger.shot() ? trigger.shot()->at : -1.0; };
    const auto go_to = [&](std::int64_t tick) {
      while (fed < tick) {
        feed(rig, fed, fed + 20, shape);
        trigger.search(rig.store);
      }
    };
    go_to(400);
    QCOMPARE(shown(), -1.0);
    go_to(1000);
    QCOMPARE(shown(), 0.5);
    go_to(1800);
    QCOMPARE(shown(), second);
    go_to(9000);
    QCOMPARE(shown(), later);
    QCOMPARE(trigger.count(), std::uint64_t(mode == TriggerMode::single ? 1 : 2));
  }

  void only_what_comes_after_arming_triggers() {
    TrackRig rig({"force"});
    std::int64_t fed = 0;
    feed(rig, fed, 1000, [](std::int64_t tick) { return spike_at(tick, 500); });
    Trigger trigger;
    trigger.arm(rig.store, {.signal = "force", .level = 3.0, .after = 0.05});
    QVERIFY(!trigger.search(rig.store));
    feed(rig, fed, 2000, [](std::int64_t tick) { return spike_at(tick, 1000); });
    QVERIFY(trigger.search(rig.store));
    QCOMPARE(trigger.shot()->at, 1.0);
    rig.begin();  // another run: what was seen is of the one before
    fed = 0;
    feed(rig, fed, 10, [](std::int64_t) { return 0.0; });
    QVERIFY(trigger.search(rig.store));
    QVERIFY(!trigger.shot());
    QCOMPARE(trigger.state(), Trigger::State::armed);
  }

  void playback_triggers_at_what_is_shown_and_again_after_a_step_back() {
    TrackRig rig({"force"});
    std::int64_t fed = 0;
    feed(rig, fed, 3000, [](std::int64_t tick) { return spike_at(tick, 1000); });
    Trigger trigger;
    rig.store.set_view_end(0.5);
    trigger.arm(rig.store, {.signal = "force", .level = 3.0, .after = 0.1});
    trigger.search(rig.store);
    rig.store.set_view_end(1.05);
    QVERIFY(!trigger.search(rig.store));
    rig.store.set_view_end(1.2);
    QVERIFY(trigger.search(rig.store));
    QCOMPARE(trigger.shot()->at, 1.0);
    rig.store.set_view_end(0.3);
    QVERIFY(trigger.search(rig.store));
    QVERIFY(!trigger.shot());
    rig.store.set_view_end(2.0);
    QVERIFY(trigger.search(rig.store));
    QCOMPARE(trigger.shot()->at, 1.0);
  }

  void a_signal_that_is_not_there_does_not_trigger() {
    TrackRig rig({"force"});
    Trigger trigger;
    trigger.arm(rig.store, {.signal = "none"});
    std::int64_t fed = 0;
    feed(rig, fed, 100, [](std::int64_t) { return 9.0; });
    QVERIFY(!trigger.search(rig.store));
    trigger.disarm();
    QCOMPARE(trigger.state(), Trigger::State::off);
  }

  // --- statistics ---
  void statistics_are_those_of_whole_periods_of_a_sine() {
    TrackRig rig({"force"});
    constexpr double offset = 1e6, amplitude = 2.0;
    std::int64_t fed = 0;
    feed(rig, fed, 10'000, [](std::int64_t tick) {
      return offset + amplitude * std::sin(2 * M_PI * static_cast<double>(tick) / 500.0);
    });
    const SignalRef signal = *rig.store.find("force");
    const RangeStatistics s = statistics_of(signal, 1.0, 5.9995);  // 5000 rows, ten periods
    QCOMPARE(s.count, std::uint64_t{5000});
    QVERIFY(std::abs(s.mean - offset) < 1e-8);
    QVERIFY(std::abs(s.deviation - amplitude / std::sqrt(2.0)) < 1e-6);
    QVERIFY(std::abs(s.rms - std::hypot(offset, amplitude / std::sqrt(2.0))) < 1e-6);
    QVERIFY(std::abs(s.max - offset - amplitude) < 1e-6);
    QVERIFY(std::abs(s.min - offset + amplitude) < 1e-6);
  }

  void statistics_leave_out_what_is_no_number() {
    TrackRig rig({"force"});
    std::int64_t fed = 0;
    feed(rig, fed, 4, [](std::int64_t tick) { return tick == 1 ? std::nan("") : 3.0; });
    const SignalRef signal = *rig.store.find("force");
    const RangeStatistics s = statistics_of(signal, 0.0, 1.0);
    QCOMPARE(s.count, std::uint64_t{3});
    QCOMPARE(s.mean, 3.0);
    QCOMPARE(s.deviation, 0.0);
    const RangeStatistics nothing = statistics_of(signal, 5.0, 6.0);
    QCOMPARE(nothing.count, std::uint64_t{0});
    QVERIFY(std::isnan(nothing.mean) && std::isnan(nothing.min) && std::isnan(nothing.rms));
    QVERIFY(std::isnan(value_at(signal, -1.0)));
    QCOMPARE(value_at(signal, 0.0025), 3.0);
  }

  void the_value_table_measures_between_the_cursors() {
    TrackRig rig({"a", "b"});
    rig.feed(0, 2000, rate, [](std::size_t i, std::int64_t tick) {
      return i == 0 ? static_cast<double>(tick) : 7.0;
    });
    ValueTable table;
    const std::vector<PlotDescription> plots = {{.names = {"a"}}, {.names = {"b", "gone"}}};
    const TimeWindow window{0.999, 1.999, 1.999};
    table.fill(rig.store, plots, window, Cursors{-0.5, -0.1});  // 1499 and 1899
    QCOMPARE(table.rows().size(), std::size_t{3});
    const auto text = [&](std::size_t row, std::size_t column) {
      return table.rows()[row][column].text;
    };
    QStringList first;
    for (std::size_t column = 0; column < table.rows()[0].size(); ++column)
      first << text(0, column);
    QCOMPARE(first.size(), ValueTable::header().size());
    QCOMPARE(first.mid(0, 10), (QStringList{"1", "a", "N", "1999.00", "1499.00", "1899.00",
                                            "400.00", "1499.00", "1899.00", "1699.00"}));
    QCOMPARE(first.last(), QString("401"));
    QCOMPARE(text(2, 3), QString("–"));  // never 0
    QCOMPARE(table.sources()[2].signal, std::string("gone"));
    QCOMPARE(ValueTable::difference_text({-0.5, -0.1}), QString("B − A  400.0 ms,  2.5 Hz"));
    table.fill(rig.store, plots, window, std::nullopt);
    QCOMPARE(table.rows()[0].back().text, QString("1001"));
    QCOMPARE(text(0, 4), QString("–"));
  }

  // --- signals ---
  void the_tree_has_each_signal_once_by_its_parts() {
    TrackRig rig({"wall.force.x", "wall.force.z", "wall.depth", "tip.x"});
    SignalTree tree(rig.store);
    const QAbstractItemModelTester tester(&tree);
    const QModelIndex wall = tree.match(tree.index(0, 0), Qt::DisplayRole, "wall").value(0);
    QVERIFY(wall.isValid());
    QCOMPARE(tree.names_of({wall}), (QStringList{"wall.force.x", "wall.force.z", "wall.depth"}));
    const QModelIndex force = tree.index(0, 0, wall);
    QCOMPARE(tree.names_of({force, wall}).size(), qsizetype{3});  // none twice
    const std::unique_ptr<QMimeData> mime(tree.mimeData({force}));
    QCOMPARE(mime->data(SignalTree::mime_type), QByteArray("wall.force.x\nwall.force.z"));
    QVERIFY(tree.flags(force).testFlag(Qt::ItemIsDragEnabled));
    QVERIFY(tree.index(0, 1, force).data().toString() == "–");
    rig.feed(0, 10, rate, [](std::size_t, std::int64_t) { return 2.5; });
    QCOMPARE(tree.index(0, 1, force).data().toString(), QString("2.50 N"));
    QCOMPARE(tree.count(), 9);  // the head of a row has five
    rig.begin();
    QCOMPARE(tree.count(), 9);
  }

  // --- tables ---
  void the_table_has_the_visible_rows_and_reads_back_the_same() {
    TrackRig rig({"a", "b"});
    rig.feed(0, 100, rate, [](std::size_t i, std::int64_t tick) {
      return i == 0 ? 0.1 * static_cast<double>(tick) : std::nan("");
    });
    const QString text = QString::fromStdString(csv_of(rig.store, {"a", "b", "gone"}, 0.01, 0.013));
    const QStringList lines = text.split('\n');
    QCOMPARE(lines[0], QString("time [s],a [N],b [N]"));
    QCOMPARE(lines.size(), qsizetype{6});
    QCOMPARE(lines[1], QString("0.01,1,nan"));
    for (int i = 0; i < 4; ++i) {
      const QStringList cells = lines[1 + i].split(',');
      QCOMPARE(cells[0].toDouble(), (10 + i) * 1e6 / 1e9);
      QCOMPARE(cells[1].toDouble(), 0.1 * (10 + i));
    }
    const QTemporaryDir folder;
    const QString path = folder.filePath("x.csv");
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, write_csv(path, rig.store, {"gone"}, 0, 1));
    QVERIFY(!QFile::exists(path));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error,
                             write_csv("/nowhere/x.csv", rig.store, {"a"}, 0, 1));
    write_csv(path, rig.store, {"a"}, 0, 1);
    QVERIFY(QFile::exists(path));
  }

  // --- layouts ---
  void a_layout_reads_back_as_it_was() {
    PlotLayout layout;
    layout.span = 2.5;
    layout.events = false;
    layout.cursors = {-1.5, -0.25};
    layout.trigger = TriggerSettings{.signal = "wall.force.z",
                                     .when = When::falls,
                                     .mode = TriggerMode::single,
                                     .level = -1.25,
                                     .hysteresis = 0.1,
                                     .before = 0.0,
                                     .after = 3.0};
    layout.plots = {{.title = "Force", .names = {"a", "b"}, .height = 2.0},
                    {.kind = PlotDescription::Kind::xy, .names = {"x", "y"}}};
    QCOMPARE(read_layout(layout_text(layout)), layout);
    QCOMPARE(read_layout(layout_text(PlotLayout())), PlotLayout());
    QCOMPARE(read_layout(R"({"trocar_layout": 1, "plots": [{"signals": ["a"]}]})").plots[0].names,
             std::vector<std::string>{"a"});
  }

  void a_layout_that_is_wrong_is_told_where_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const char* members, const char* says) {
      QTest::newRow(name) << QByteArray(members) << QString(says);
    };
    row("no JSON", "{", "the layout is no JSON");
    row("a list", "[]", "the layout is [] and not an object");
    row("another file", R"({"plots": []})", "has no \"trocar_layout\": 1");
    row("a newer one", R"({"trocar_layout": 2, "plots": []})",
        "version 2, and this program reads 1");
    row("no plots", R"({"trocar_layout": 1})", "the layout has no list \"plots\"");
    row("misspelt", R"({"trocar_layout": 1, "plots": [], "spam": 2})",
        "has \"spam\", which is unknown, did you mean \"span\"?");
    row("a span out of range", R"({"trocar_layout": 1, "plots": [], "span": 0})",
        "span = 0, which is no number from 0.01 to 600");
    row("a span in words", R"({"trocar_layout": 1, "plots": [], "span": "ten"})",
        "span = \"ten\", which is no number");
    row("a kind",
        R"({"trocar_layout": 1, "plots": [{"signals": []}, {"kind": "tine", "signals": []}]})",
        "plot 2 has kind = \"tine\", did you mean \"time\"?");
    row("xy of one", R"({"trocar_layout": 1, "plots": [{"kind": "xy", "signals": ["a"]}]})",
        "plot 1 is of kind \"xy\" and has 1 signals instead of two");
    row("a signal", R"({"trocar_layout": 1, "plots": [{"signals": [7]}]})",
        "plot 1 has the signal 7, which is no text");
    row("cursors", R"({"trocar_layout": 1, "plots": [], "cursors": [1]})", "cursors = [1]");
    row("a trigger", R"({"trocar_layout": 1, "plots": [], "trigger": {"when": "raises"}})",
        "the trigger has when = \"raises\", did you mean \"rises\"?");
    row("events", R"({"trocar_layout": 1, "plots": [], "events": 1})", "events = 1: true or false");
  }
  void a_layout_that_is_wrong_is_told_where() {
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const QString said = complaint(text);
    QVERIFY2(said.contains(says), qPrintable(said));
  }

  void a_layout_is_kept_in_a_file() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("contact.json");
    PlotLayout layout;
    layout.plots = {{.title = "µ", .names = {"a"}}};
    write_layout_file(path, layout);
    QCOMPARE(read_layout_file(path), layout);
    QFile file(path);
    QVERIFY(file.open(QFile::WriteOnly) && file.write("{}") == 2);
    file.close();
    try {
      read_layout_file(path);
      QFAIL("no error");
    } catch (const std::invalid_argument& error) {
      QVERIFY2(QString(error.what()).startsWith(path + ": the layout has no"), error.what());
    }
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, read_layout_file(folder.filePath("none.json")));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, write_layout_file("/nowhere/a.json", layout));
  }
};

QTEST_MAIN(TestAnalysis)
#include "tst_analysis.moc"
