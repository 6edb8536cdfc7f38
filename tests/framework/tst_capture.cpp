// SPDX-License-Identifier: Apache-2.0
#include "framework/capture.hpp"

#include <QTest>

#include "tests/support/run_rig.hpp"

using namespace trocar;

namespace {

/// A Capture of one of the meter's signals: value = 2 + tick, force = (tick, 2 tick, -tick).
struct CaptureRig {
  explicit CaptureRig(const std::string& port = "value", const std::string& path = "") {
    run.types.add<Capture>("Capture", "test", "captures");
    node = run.graph.add("Capture", "touch", {"rig.lua", 3}).value();
    run.graph.connect({run.meter, port, path}, {node, "signal"}, {"rig.lua", 3});
  }
  CaptureRig& set(std::string_view parameter, std::string_view value) {
    run.graph.set({node, std::string(parameter)}, literal_from_text(value), {"rig.lua", 4});
    return *this;
  }
  QString findings() { return QString::fromStdString(check(run.graph, {}).text()); }

  test::RunRig run;
  NodeId node = 0;
};

/// Hands the trigger the rows of a run.
struct Watcher final : RowSink {
  explicit Watcher(SignalTrigger& watched) : trigger(watched) {}
  void begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) override {
    window = trigger.begin(layouts, graph);
  }
  void row(std::size_t group, std::span<const std::byte> row) override {
    if (!trigger.row(group, row)) return;
    ticks.push_back(static_cast<int>(header_of(row).tick));
    causes.push_back(QString::fromStdString(trigger.cause()));
  }
  SignalTrigger& trigger;
  Trigger::Window window{};
  QList<int> ticks;
  QStringList causes;
};

}  // namespace

class TestCapture : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_is_refused_with_the_reason_data() {
    QTest::addColumn<QString>("port");
    QTest::addColumn<QString>("parameter");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const char* port, const char* parameter,
                        const char* value, const char* says) {
      QTest::newRow(name) << port << parameter << value << says;
    };
    row("nothing is asked of the signal", "value", "after", "2 s", "needs above = \"2 N\"");
    row("another unit", "value", "above", "2 mm", "above = \"2 mm\": needs N, as the signal");
    row("another unit below", "value", "below", "2 s", "below = \"2 s\": needs N");
    row("a number without a unit", "value", "above", "2", "above = \"2\": needs N");
    row("a vector", "force", "above", "2 N", "signal is a Vector3: name a single number of it");
    row("a count", "count", "above", "2", "signal is a int64: name a single number");
    row("too long before", "value", "before", "61 s", "must be within 0–60 s");
    row("neither edge nor level", "value", "when", "edges", "did you mean \"edge\"?");
  }
  void it_is_refused_with_the_reason() {
    QFETCH(QString, port);
    QFETCH(QString, parameter);
    QFETCH(QString, value);
    QFETCH(QString, says);
    CaptureRig rig(port.toStdString());
    rig.set(parameter.toStdString(), value.toStdString());
    QVERIFY2(rig.findings().contains(says), qPrintable(rig.findings()));
  }

  void a_signal_that_is_missing_is_a_finding() {
    test::RunRig rig;
    rig.types.add<Capture>("Capture", "test", "captures");
    rig.graph.add("Capture", "touch", {"rig.lua", 3});
    const QString text = QString::fromStdString(check(rig.graph, {}).text());
    QVERIFY2(text.contains("touch.signal"), qPrintable(text));
  }

  void it_triggers_data() {
    QTest::addColumn<QString>("parameter");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("when");
    QTest::addColumn<QList<int>>("ticks");
    const auto row = [](const char* name, const char* parameter, const char* value,
                        const char* when, const QList<int>& ticks) {
      QTest::newRow(name) << parameter << value << when << ticks;
    };
    row("once as it gets above", "above", "8.5 N", "edge", {7});
    row("only above, not at it", "above", "9 N", "edge", {8});
    row("in each row above", "above", "8.5 N", "level", {7, 8, 9});
    row("not where it was above from the beginning", "above", "1 N", "edge", {});
    row("from the beginning by level", "below", "4 N", "level", {0, 1});
    row("not as it leaves", "below", "4 N", "edge", {});
    row("never", "above", "100 N", "level", {});
    row("in another unit of the same", "above", "0.0085 kN", "edge", {7});
    row("beyond a bare zero", "above", "0", "level", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  }
  void it_triggers() {
    QFETCH(QString, parameter);
    QFETCH(QString, value);
    QFETCH(QString, when);
    QFETCH(QList<int>, ticks);
    CaptureRig rig;
    rig.set(parameter.toStdString(), value.toStdString()).set("when", when.toStdString());
    SignalTrigger trigger("touch");
    Watcher watcher(trigger);
    rig.run.run(0.01, {&watcher});
    QCOMPARE(watcher.ticks, ticks);
  }

  void a_field_is_watched_where_it_lies() {
    CaptureRig rig("force", "z");
    rig.set("below", "-5.5 N").set("before", "20 ms").set("after", "0.5 s");
    SignalTrigger trigger("touch");
    Watcher watcher(trigger);
    rig.run.run(0.01, {&watcher});
    QCOMPARE(watcher.causes, (QStringList{"meter.force.z below -5.5 N at tick 6 (0.006 s): -6 N"}));
    QCOMPARE(watcher.window.before, 0.02);
    QCOMPARE(watcher.window.after, 0.5);
  }

  void what_is_no_number_triggers_nothing() {
    CaptureRig rig;
    rig.set("above", "1 N").set("below", "-1 N").set("when", "level");
    rig.run.graph.set({rig.run.meter, "broken_from"}, literal_from_text("0"), {"test", 3});
    SignalTrigger trigger("touch");
    Watcher watcher(trigger);
    rig.run.run(0.01, {&watcher});
    QVERIFY(watcher.ticks.empty());
  }
};

QTEST_APPLESS_MAIN(TestCapture)
#include "tst_capture.moc"
