// SPDX-License-Identifier: Apache-2.0
#include "framework/run.hpp"

#include <QTest>

#include "tests/support/run_rig.hpp"

using namespace trocar;
using test::edit_of;
using test::RunRig;
using test::TestSink;

class TestRun : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_run_takes_its_slots_and_keeps_its_rows() {
    RunRig rig;
    const RunResult result = rig.run(0.05);
    QCOMPARE(result.main().loop.ticks, std::int64_t{50});
    QCOMPARE(result.duration, 0.05);
    QCOMPARE(result.main().rate, 1000.0);
    QCOMPARE(result.rows->rows(), std::size_t{50});
    QCOMPARE(result.rows->time().back(), 0.049);
    const auto column = [&](const char* name) {
      return result.rows->column(*result.rows->find(name));
    };
    QCOMPARE(column("meter.value")[7], 9.0);
    QCOMPARE(column("meter.force.y")[7], 14.0);
    QCOMPARE(column("meter.count")[7], -7.0);
    QCOMPARE(column("meter.odd")[6], 0.0);
    QCOMPARE(column("meter.odd")[7], 1.0);
    QVERIFY(result.rows->find("meter.missing") == nullptr);
    QVERIFY(result.faults.empty() && result.lost.empty() && !result.interrupted);
  }

  void more_rows_than_are_read_at_once_come_in_order() {
    RunRig rig;
    const RunResult result = rig.run(2.0);
    const std::vector<double> counts = result.rows->column(*result.rows->find("meter.count"));
    QCOMPARE(counts.size(), std::size_t{2000});
    for (std::size_t i = 0; i < counts.size(); ++i) QCOMPARE(counts[i], -static_cast<double>(i));
  }

  void a_graph_can_be_run_again_from_its_start() {
    RunRig rig;
    rig.run(0.3, {}, {edit_of("meter.gain", "9 N")});
    const RunResult again = rig.run(0.01);
    QCOMPARE(again.rows->column(*again.rows->find("meter.value"))[0], 2.0);
  }

  void an_edit_arrives_at_its_time() {
    RunRig rig;
    const RunResult result = rig.run(0.4, {}, {edit_of("meter.gain", "4 N", 0.1)});
    const std::vector<double> value = result.rows->column(*result.rows->find("meter.value"));
    QCOMPARE(value[99], 2.0 + 99);
    QCOMPARE(value[199], 3.0 + 199);
    QCOMPARE(value[299], 4.0 + 299);
  }

  void an_edit_that_cannot_be_is_a_finding_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("says");
    QTest::newRow("no such parameter") << "meter.gian"
                                       << "1 N"
                                       << "did you mean";
    QTest::newRow("no parameter at all") << "meter"
                                         << "1 N"
                                         << "nothing is called";
    QTest::newRow("one that is not live") << "meter.fixed"
                                          << "1 N"
                                          << "cannot be edited";
    QTest::newRow("another unit") << "meter.gain"
                                  << "1 m"
                                  << "meter.gain = ";
    QTest::newRow("beyond the range") << "meter.gain"
                                      << "10 N"
                                      << "9 N";
    QTest::newRow("a group's that nothing follows") << "pair.loose"
                                                    << "1 m"
                                                    << "cannot be edited";
  }
  void an_edit_that_cannot_be_is_a_finding() {
    QFETCH(QString, key);
    QFETCH(QString, value);
    QFETCH(QString, says);
    struct Loose final : Group {
      Parameter<double> loose{this, "loose", {.unit = "m", .initial = "1 m", .live = true}};
      void build(GroupScope& scope) override { scope.add("Number", "part"); }
    };
    RunRig rig;
    rig.types.add<Loose>("Loose", "test", "a group");
    rig.graph.build_group(rig.graph.add("Loose", "pair", {"test", 3}).value());
    TestSink sink;
    try {
      rig.run(0.1, {&sink}, {edit_of(key.toStdString(), value.toStdString())});
      QFAIL("it ran");
    } catch (const BrokenGraph& broken) {
      const QString text = QString::fromStdString(broken.findings.text());
      QVERIFY2(text.contains(says) && text.contains("rig.lua:7"), qPrintable(text));
    }
    QCOMPARE(sink.kinds.size(), std::size_t{0});
  }

  void a_sink_that_throws_is_left_out_and_named_while_others_go_on_data() {
    using Throws = TestSink::Throws;
    QTest::addColumn<int>("when");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, Throws when, const char* says) {
      QTest::newRow(name) << static_cast<int>(when) << says;
    };
    row("at the beginning", Throws::in_begin, "sink is full");
    row("at a row", Throws::in_row, "sink is full");
    row("at an event", Throws::in_event, "sink is full");
    row("at the end", Throws::in_end, "sink is full");
    row("what is no exception of the library's", Throws::without_a_word, "did not say why");
  }
  void a_sink_that_throws_is_left_out_and_named_while_others_go_on() {
    QFETCH(int, when);
    QFETCH(QString, says);
    const auto throws = static_cast<TestSink::Throws>(when);
    RunRig rig;
    TestSink before, broken(throws), behind;
    // Far more rows than the ring holds: who empties it must not have died.
    const RunResult result = rig.run(60.0, {&before, &broken, &behind});
    QCOMPARE(result.lost.size(), std::size_t{1});
    QVERIFY(QString::fromStdString(result.lost[0]).contains(says));
    for (const TestSink* sink : {&before, &behind}) {
      QCOMPARE(sink->rows, 60'000);
      QCOMPARE(sink->ends, 1);
    }
    QVERIFY(broken.rows <= 1 || throws == TestSink::Throws::in_end);
    QCOMPARE(result.main().loop.rows_lost, std::int64_t{0});
  }

  void a_fault_is_told_with_its_texts() {
    RunRig rig;
    rig.graph.set({rig.meter, "broken_from"}, literal_from_text("20"), {"test", 3});
    TestSink sink;
    const RunResult result = rig.run(0.05, {&sink});
    QCOMPARE(result.faults.size(), std::size_t{1});
    QCOMPARE(result.faults[0].text(),
             std::string("not finite in meter at tick 20 (0.020 s): an output"));
    QVERIFY(sink.kinds ==
            (std::vector{Event::Kind::started, Event::Kind::fault, Event::Kind::ended}));
  }

  void timing_out_of_range_is_refused_in_real_time_data() {
    QTest::addColumn<double>("spin");
    QTest::addColumn<int>("allowed");
    QTest::addColumn<QString>("says");
    QTest::newRow("a spin of the period") << 1e-3 << 20 << "a guard spin of 1000 µs";
    QTest::newRow("a spin below 0") << -1e-6 << 20 << "a guard spin of -1 µs";
    QTest::newRow("no number") << std::nan("") << 20 << "a guard spin of";
    QTest::newRow("beyond all numbers") << 1e300 << 20 << "shorter than the period";
    QTest::newRow("a count below 0") << 0.0 << -1 << "overload.allowed = -1";
  }
  void timing_out_of_range_is_refused_in_real_time() {
    QFETCH(double, spin);
    QFETCH(int, allowed);
    QFETCH(QString, says);
    RunRig rig;
    RunOptions options{.timing = {.spin = spin, .overload = {.allowed = allowed}}};
    options.duration = 0.01;
    try {
      run(rig.graph, options);
      QFAIL("it ran");
    } catch (const std::invalid_argument& error) {
      QVERIFY2(QString(error.what()).contains(says), error.what());
    }
  }

  void a_run_that_is_stopped_says_so() {
    RunRig rig;
    StopFlag stop;
    stop.raise();
    RunOptions options = test::wanted();
    options.stop = &stop;
    const RunResult result = run(rig.graph, options);
    QVERIFY(result.interrupted);
    QCOMPARE(result.rows->rows(), std::size_t{0});
  }

  void a_graph_without_components_runs_too() {
    Registry types;
    const Graph graph(types);
    const RunResult result = run(graph, test::wanted(0.01));
    QCOMPARE(result.rows->rows(), std::size_t{10});
  }
};

QTEST_APPLESS_MAIN(TestRun)
#include "tst_run.moc"
