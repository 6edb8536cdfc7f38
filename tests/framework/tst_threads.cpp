// SPDX-License-Identifier: Apache-2.0
// Graphs of several threads: how values cross, in virtual and in real time, and what is refused.
#include <limits>

#include <QTest>

#include "framework/logger.hpp"
#include "framework/loop_runner.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/run_rig.hpp"
#include "tests/support/script_bench.hpp"

using namespace trocar;

namespace {

/// Its tick, and no number from a tick on.
struct Counter final : Component {
  Parameter<std::int64_t> broken_from{this, "broken_from", {.initial = "1e15"}};
  Output<double> value{this, "value", {.unit = "m"}};
  void step(const Tick& tick) RT_SAFE override {
    *value = tick.index < *broken_from ? static_cast<double>(tick.index)
                                       : std::numeric_limits<double>::quiet_NaN();
  }
};

/// What it knows of its input.
struct Reader final : Component {
  Input<double> input{this, "input", {.unit = "m", .doc = "what it reads"}};
  Output<double> age{this, "age", {.unit = "s"}};
  Output<bool> fresh{this, "fresh", {}};
  void step(const Tick&) RT_SAFE override {
    *age = input.sample().age;
    *fresh = input.sample().fresh;
  }
};

struct Rig {
  Rig() {
    types.add<Counter>("Counter", "test", "its tick");
    types.add<Reader>("Reader", "test", "what it knows of its input");
    types.add<test::Meter>("Meter", "test", "numbers that follow from the tick");
  }
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;

  NodeId add(ThreadId thread, std::string_view type, std::string_view name = "") {
    const ThreadScope scope(graph, thread);
    return graph.add(type, name, {"rig", 1}).value();
  }
  ThreadId thread(const char* name, double rate, int priority = 80, double phase = 0.0) {
    return graph.add_thread({.name = name,
                             .rate = rate,
                             .phase = phase,
                             .priority = priority,
                             .processor = {},
                             .where = {"rig", 1}});
  }
  void cross(NodeId from, const char* output, NodeId to, const char* input,
             const std::optional<Connection>& connection = Connection{}) {
    graph.connect({from, output, "", connection}, {to, input}, {"rig", 2});
  }
  RunResult run(double duration) { return trocar::run(graph, test::wanted(duration)); }
  QString findings() const { return QString::fromStdString(check(graph, {}).text()); }

  Registry types = test::registry();
  Graph graph{types};
};

std::vector<double> column(const RunResult& result, const char* name) {
  return result.rows->column(*result.rows->find(name));
}

}  // namespace

class TestThreads : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void what_is_refused_data() {
    QTest::addColumn<QString>("finding");
    const auto row = [](const char* name, const char* finding) {
      QTest::newRow(name) << QString(finding);
    };
    row("a wire that does not say how",
        "counter.value → reader.input goes from thread fast to thread slow: say how, by "
        "counter.value:latest { stale = \"3 ms\" }");
    row("a way across inside a thread", "both are in thread fast; take counter.value without");
    row("a queue that fills up", "a queue from 1000 Hz to 100 Hz fills up");
    row("a limit shorter than the period", "stale = 0.5 ms is less than the 1 ms");
    row("no rate", "a rate of 0 Hz");
    row("a priority", "priority = 99: 1 to 98");
    row("a phase", "needs 0 to less than the period");
  }
  void what_is_refused() {
    QFETCH(QString, finding);
    const QString mistake = QTest::currentDataTag();
    Rig rig;
    if (mistake == "no rate") rig.thread("none", 0.0);
    if (mistake == "a priority") rig.thread("high", 100.0, 99);
    if (mistake == "a phase") rig.thread("late", 100.0, 80, 0.01);
    const ThreadId fast = rig.thread("fast", 1000.0);
    const ThreadId slow = rig.thread("slow", 100.0);
    const bool same = mistake == "a way across inside a thread";
    const NodeId counter = rig.add(fast, "Counter");
    const NodeId reader = rig.add(same ? fast : slow, "Reader");
    std::optional<Connection> connection = Connection{};
    if (mistake == "a wire that does not say how") connection.reset();
    if (mistake == "a queue that fills up") connection->kind = Connection::Kind::queue;
    if (mistake == "a limit shorter than the period") connection->stale = 0.5e-3;
    rig.cross(counter, "value", reader, "input", connection);
    QVERIFY2(rig.findings().contains(finding), qPrintable(rig.findings()));
  }

  void in_virtual_time_a_value_arrives_at_a_strictly_later_tick_data() {
    QTest::addColumn<int>("priority");  // of the reader; the writer's is 50
    QTest::newRow("the reader goes first") << 90;
    QTest::newRow("the writer goes first") << 10;
  }
  void in_virtual_time_a_value_arrives_at_a_strictly_later_tick() {
    QFETCH(int, priority);
    Rig rig;
    const NodeId counter = rig.add(rig.thread("fast", 1000.0, 50), "Counter");
    const NodeId reader = rig.add(rig.thread("slow", 100.0, priority), "Reader");
    rig.cross(counter, "value", reader, "input");
    const RunResult result = rig.run(0.1);
    QCOMPARE(result.threads.size(), std::size_t{2});
    QCOMPARE(result.threads[0].loop.ticks, std::int64_t{100});
    QCOMPARE(result.threads[1].loop.ticks, std::int64_t{10});
    const auto read = column(result, "reader.input");
    const auto tick = column(result, "reader.input_tick");
    const auto valid = column(result, "reader.input_valid");
    const auto age = column(result, "reader.age");
    QCOMPARE(tick[0], -1.0);
    QCOMPARE(valid[0], 0.0);
    for (std::size_t k = 1; k < 10; ++k) {
      QCOMPARE(read[k], 10.0 * static_cast<double>(k) - 1.0);
      QCOMPARE(tick[k], read[k]);
      QCOMPARE(valid[k], 1.0);
      QVERIFY(std::abs(age[k] - 1e-3) < 1e-12);
    }
    QVERIFY(result.faults.empty());
  }

  void a_phase_moves_a_thread() {
    Rig rig;
    const NodeId counter = rig.add(rig.thread("fast", 1000.0), "Counter");
    const NodeId reader = rig.add(rig.thread("slow", 100.0, 80, 5.5e-3), "Reader");
    rig.cross(counter, "value", reader, "input");
    const RunResult result = rig.run(0.1);
    QCOMPARE(column(result, "reader.input")[3], 35.0);
    QVERIFY(std::abs(column(result, "reader.age")[3] - 0.5e-3) < 1e-12);
    QVERIFY(std::abs(result.rows->time(1)[3] - 35.5e-3) < 1e-12);
  }

  void a_slow_value_stays_and_is_fresh_once() {
    Rig rig;
    const NodeId counter = rig.add(rig.thread("slow", 100.0), "Counter");
    const NodeId reader = rig.add(rig.thread("fast", 1000.0), "Reader");
    rig.cross(counter, "value", reader, "input");
    const RunResult result = rig.run(0.1);
    const auto read = column(result, "reader.input");
    const auto fresh = column(result, "reader.fresh");
    for (std::size_t k = 1; k < read.size(); ++k) {
      QCOMPARE(read[k], std::floor(static_cast<double>(k - 1) / 10.0));
      QCOMPARE(fresh[k], k % 10 == 1 ? 1.0 : 0.0);
    }
  }

  void a_queue_gives_each_value_once_in_order() {
    Rig rig;
    const NodeId counter = rig.add(rig.thread("slow", 250.0), "Counter");
    const NodeId reader = rig.add(rig.thread("fast", 1000.0), "Reader");
    rig.cross(counter, "value", reader, "input", Connection{.kind = Connection::Kind::queue});
    const RunResult result = rig.run(0.1);
    const auto read = column(result, "reader.input");
    const auto fresh = column(result, "reader.fresh");
    double next = 0.0;
    for (std::size_t k = 0; k < read.size(); ++k)
      if (fresh[k] != 0.0) QCOMPARE(read[k], next++);
    QCOMPARE(next, 25.0);
  }

  void a_loop_across_threads_needs_no_delay() {
    Rig rig;
    const ThreadId one = rig.thread("one", 1000.0), two = rig.thread("two", 500.0);
    const NodeId first = rig.add(one, "Follower", "first");
    const NodeId second = rig.add(two, "Follower", "second");
    rig.cross(first, "value", second, "input");
    rig.cross(second, "value", first, "input");
    QCOMPARE(rig.findings(), QString());
  }

  void what_is_not_sound_in_one_thread_ends_the_rendering_of_another() {
    Rig rig;
    const ThreadId servo = rig.thread("servo", 1000.0), scene = rig.thread("scene", 100.0);
    const NodeId arm = rig.add(servo, "TestDevice", "arm");
    const NodeId statics = rig.add(servo, "Statics");
    const NodeId counter = rig.add(scene, "Counter");
    rig.graph.set({counter, "broken_from"}, {5.0}, {"rig", 3});
    rig.cross(statics, "effort", arm, "effort", std::nullopt);
    rig.cross(counter, "value", statics, "offset");
    const RunResult result = rig.run(0.1);
    QVERIFY(result.faults.size() >= 2);
    QCOMPARE(result.faults[0].component, std::string("counter"));
    QCOMPARE(result.faults[0].tick, std::int64_t{5});
    QCOMPARE(result.faults[1].component, std::string("statics"));
    QCOMPARE(result.faults[1].cause, std::string("signal lost"));
    QCOMPARE(result.faults[1].tick, std::int64_t{51});
    const auto scale = column(result, "arm.scale");
    QVERIFY(scale[50] > 0.0);
    for (std::size_t k = 51; k < scale.size(); ++k) QCOMPARE(scale[k], 0.0);
    const auto sent = column(result, "arm.effort_sent.axis1");
    for (const double effort : sent) QVERIFY(std::isfinite(effort));
  }

  void a_stale_value_is_lost_and_what_comes_later_is_good_again() {
    double value = 1.0, copy = 0.0;
    std::int64_t tick = 0;
    bool valid = true;
    Crossing crossing({.stale = 5e-3}, std::as_bytes(std::span(&value, 1)),
                      {reinterpret_cast<std::byte*>(&copy), &tick, &valid}, "a → b");
    const auto at = [](std::int64_t ms) {
      return Tick{ms, ms * 1'000'000, 1e-3 * static_cast<double>(ms), 1e-3};
    };
    QVERIFY(copy == 1.0 && !valid && tick == -1);
    crossing.receive(at(5), true);  // nothing yet, and it may still come
    QVERIFY(crossing.lost() == nullptr && !crossing.info().valid);
    crossing.receive(at(6), true);
    QCOMPARE(crossing.lost(), "stale");
    value = 2.0;
    QVERIFY(crossing.send(at(6), true));
    crossing.receive(at(7), true);
    QVERIFY(crossing.lost() == nullptr && valid && copy == 2.0 && tick == 6);
    crossing.receive(at(11), true);
    QVERIFY(crossing.lost() == nullptr && valid);
    crossing.receive(at(12), true);
    QVERIFY(crossing.lost() != nullptr && !valid && copy == 2.0);  // never zero
    QVERIFY(crossing.send(at(12), false));
    crossing.receive(at(13), true);
    QVERIFY(QByteArray(crossing.lost()).contains("not sound"));
  }

  void a_full_queue_says_so() {
    double value = 1.0, copy = 0.0;
    std::int64_t tick = 0;
    bool valid = true;
    Crossing crossing({.kind = Connection::Kind::queue, .size = 2},
                      std::as_bytes(std::span(&value, 1)),
                      {reinterpret_cast<std::byte*>(&copy), &tick, &valid}, "a → b");
    QVERIFY(crossing.send({.index = 0}, true) && crossing.send({.index = 1}, true));
    QVERIFY(!crossing.send({.index = 2}, true));
  }

  void an_edit_goes_to_the_thread_of_its_component() {
    Rig rig;
    rig.add(rig.thread("fast", 1000.0), "Counter");
    rig.add(rig.thread("slow", 100.0), "Meter", "meter");
    RunOptions options = test::wanted(0.4);
    options.edits = {test::edit_of("meter.gain", "4 N", 0.1)};
    const RunResult result = trocar::run(rig.graph, options);
    const auto value = column(result, "meter.value");
    QCOMPARE(value[9], 2.0 + 9.0);
    QVERIFY(value[12] > 2.0 + 12.0 && value[12] < 4.0 + 12.0);
    QCOMPARE(value[30], 4.0 + 30.0);
  }

  void a_tick_that_exchanges_allocates_nothing() {
    Rig rig;
    const ThreadId one = rig.thread("one", 1000.0), two = rig.thread("two", 500.0);
    const NodeId counter = rig.add(one, "Counter"), reader = rig.add(two, "Reader");
    const NodeId back = rig.add(two, "Counter", "back"), other = rig.add(one, "Reader", "other");
    rig.cross(counter, "value", reader, "input");
    rig.cross(back, "value", other, "input", Connection{.kind = Connection::Kind::queue});
    const auto wired = wire(rig.graph, {});
    std::deque<Executor> executors;
    for (const RateGroup& group : wired->groups()) executors.emplace_back(group, ExecutorOptions{});
    for (Executor& executor : executors) executor.start();
    const int allocations = test::allocations_in([&] {
      for (std::int64_t k = 0; k < 10'000; ++k) {
        executors[0].tick({.index = k}, true);
        if (k % 2 == 0) executors[1].tick({.index = k / 2}, true);
      }
    });
    QCOMPARE(allocations, 0);
  }

  void what_has_no_ports_makes_no_thread() {
    Rig rig;
    rig.types.add<Logger>("Logger", "test", "records");
    rig.add(Graph::main_thread, "Logger");
    rig.add(rig.thread("fast", 1000.0), "Counter");
    const auto wired = wire(rig.graph, {});
    QCOMPARE(wired->groups().size(), std::size_t{1});
    QCOMPARE(wired->main().name(), std::string("fast"));
    QCOMPARE(wired->main().schedule().size(), std::size_t{2});
  }

  void side_by_side_in_real_time() {
    Rig rig;
    const ThreadId one = rig.thread("one", 5000.0), two = rig.thread("two", 2000.0);
    const ThreadId three = rig.thread("three", 500.0), four = rig.thread("four", 1000.0);
    const ThreadId threads[] = {one, two, three, four};
    for (int i = 0; i < 4; ++i) {
      const std::string number = std::to_string(i);
      const NodeId counter = rig.add(threads[i], "Counter", "counter" + number);
      const NodeId reader = rig.add(threads[(i + 1) % 4], "Reader", "reader" + number);
      rig.cross(counter, "value", reader, "input");
    }
    RunOptions options = test::wanted(0.3);
    options.clock = ClockKind::realtime;
    options.engage = false;
    const RunResult result = trocar::run(rig.graph, options);
    QCOMPARE(result.threads.size(), std::size_t{4});
    for (const ThreadResult& thread : result.threads)
      QCOMPARE(thread.loop.ticks + thread.loop.skipped, std::llround(0.3 * thread.rate));
    for (int i = 0; i < 4; ++i) {
      const QByteArray name = "reader" + QByteArray::number(i) + ".input";
      const auto value = column(result, name);
      const auto tick = column(result, name + "_tick");
      double last = -1.0;
      for (std::size_t k = 0; k < value.size(); ++k) {
        if (tick[k] < 0.0) continue;
        QCOMPARE(value[k], tick[k]);  // value and date belong together
        QVERIFY(tick[k] >= last);
        last = tick[k];
      }
      QVERIFY(last > 0.0);
    }
  }

  void three_threads_give_the_same_bytes_twice() {
    const QByteArray script =
        "local servo = trocar.thread { rate = \"1 kHz\", priority = 80 }\n"
        "local scene = trocar.thread { rate = \"125 Hz\", priority = 40 }\n"
        "local slow = trocar.thread { rate = \"30 Hz\", phase = \"7 ms\" }\n"
        "local l = servo.Laparoscope { hand = \"push\" }\n"
        "local wall = servo.Wall { at = l.tip, point = { 0, 0, \"105 mm\" },\n"
        "  normal = { 0, 0, -1 }, stiffness = \"1 N/mm\" }\n"
        "local tissue = scene.Creep { load = wall.load:latest { stale = \"5 ms\" } }\n"
        "local breath = slow.Sine { amplitude = \"3 mm\", frequency = \"1 Hz\" }\n"
        "local surface = (breath.value:queue { size = 8 } - tissue.depth):as \"surface\"\n"
        "surface:latest { stale = \"100 ms\" }:to(wall.offset)\n";
    const QTemporaryDir folder;
    QByteArray bytes[2];
    for (int i = 0; i < 2; ++i) {
      const QString log = folder.filePath(QString::number(i));
      SessionOptions options;
      options.duration = 3.0;
      options.record = log.toStdString();
      const test::ScriptOutcome outcome = test::run_script_text(script, {}, options);
      QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
      QVERIFY(outcome.session->sound());
      QCOMPARE(outcome.session->runs()[0]->result.threads.size(), std::size_t{3});
      QCOMPARE(outcome.session->runs()[0]->result.threads[2].name, std::string("slow"));
      QFile file(log);
      QVERIFY(file.open(QFile::ReadOnly));
      bytes[i] = file.readAll();
    }
    QVERIFY(bytes[0].size() > 100'000);
    QVERIFY(bytes[0] == bytes[1]);
  }
};

QTEST_GUILESS_MAIN(TestThreads)
#include "tst_threads.moc"
