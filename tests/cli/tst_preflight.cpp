// SPDX-License-Identifier: Apache-2.0
// `trocar check --preflight`: what a run in virtual time says of one in real time.
#include "cli/preflight.hpp"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "cli/heap_allocations.hpp"
#include "framework/graph.hpp"
#include "tests/cli/trocar_process.hpp"

using namespace trocar;
using namespace trocar::cli;
using namespace trocar::test;

namespace {

/// Allocates in its step at and after a time, as no component may.
struct Hoarder final : Component {
  Output<double> value{this, "value", {.doc = "nothing"}};
  Parameter<double> from{this, "from", {.unit = "s", .initial = "0 s", .doc = "when"}};
  std::vector<std::unique_ptr<int>> hoard;

  void configure(const Setup&) override { hoard.reserve(1000); }
  void step(const Tick& tick) RT_SAFE override {
    if (tick.time >= *from) hoard.push_back(std::make_unique<int>(1));
  }
};

Registry registry() {
  Registry all;
  all.add<Hoarder>("Hoarder", "tests", "Allocates");
  return all;
}

std::uint64_t none() RT_SAFE {
  return 0;
}

}  // namespace

class TestPreflight : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  const Registry registry_ = registry();

  static void write(const QString& name, const QByteArray& text) {
    QFile file(name);
    QVERIFY(file.open(QFile::WriteOnly) && file.write(text) == text.size());
  }
  static nlohmann::json json_of(const Ran& ran) {
    return nlohmann::json::parse(ran.out.toStdString(), nullptr, false);
  }

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(QDir::setCurrent(folder_.path()));
    write("sound.lua",
          "local laparoscope = trocar.Laparoscope { hand = 'push' }\n"
          "trocar.Wall { at = laparoscope.tip, point = { 0, 0, '105 mm' }, normal = { 0, 0, -1 },\n"
          "              stiffness = '1 N/mm' }\n"
          "trocar.Logger { file = 'sound.mcap' }\n");
    write("stops.lua",
          "local laparoscope = trocar.Laparoscope {}\n"
          "trocar.run { duration = '1 s', requests = { { at = '0.5 s', ask = 'stop' } } }\n"
          "error('beyond the first run')\n");
    write("law.lua",
          "return trocar.fixture { step = function(p, at, out, state, tick)\n"
          "  local v = at.position:copy()\n"
          "  if tick.time > 0.2 then out.nothing = v end\n"
          "end }\n");
    write("fails.lua",
          "local laparoscope = trocar.Laparoscope {}\n"
          "trocar.LuaFixture { name = 'law', file = 'law.lua', at = laparoscope.tip }\n");
    write("hoard.lua", "trocar.Hoarder { name = 'hoarder', from = '0.1 s' }\n");
    write("broken.lua", "\ntrocar.Wal {}\n");
  }

  void operator_new_is_counted_in_this_thread() {
    const std::uint64_t before = heap_allocations();
    const auto one = std::make_unique<int>(1);
    const auto list = std::make_unique<int[]>(10);
    struct alignas(64) Wide {
      double numbers[8];
    };
    const auto wide = std::make_unique<Wide>();
    QCOMPARE(heap_allocations() - before, std::uint64_t(3));
    QCOMPARE(reinterpret_cast<std::uintptr_t>(wide.get()) % 64, std::uintptr_t(0));
  }

  void a_step_that_allocates_is_a_failure() {
    const Preflight result =
        preflight(registry_, "hoard.lua", {.duration = 0.5, .allocations = heap_allocations}, {});
    const ComponentTiming& hoarder = result.run.main().components.at(0);
    QCOMPARE(hoarder.cost.allocations, std::uint64_t(400));
    QCOMPARE(hoarder.cost.allocation_tick, std::int64_t(100));
    QCOMPARE(result.failures(),
             std::vector<std::string>{"hoarder allocates memory in its steps: 400 allocations, the "
                                      "first at tick 100"});
  }

  void a_step_that_does_not_is_none() {
    const Preflight result =
        preflight(registry_, "hoard.lua", {.duration = 0.05, .allocations = heap_allocations}, {});
    QCOMPARE(result.failures(), std::vector<std::string>());
    const ThreadResult& thread = result.run.main();
    QCOMPARE(thread.components.at(0).cost.steps, std::uint64_t(50));
    QVERIFY(thread.components.at(0).cost.worst_tick > 0);
    QVERIFY(thread.loop.tick_cost.worst_ns >= thread.components.at(0).cost.worst_ns);
    QVERIFY(std::max(thread.loop.tick_cost.worst_ns, thread.loop.tick_cost.first_ns) ==
            thread.loop.duration.max());
  }

  void who_does_not_count_keeps_nothing() {
    const Preflight silent = preflight(registry_, "hoard.lua", {.duration = 0.5}, {});
    QCOMPARE(silent.run.main().components.at(0).cost.steps, std::uint64_t(0));
    const Preflight deaf =
        preflight(registry_, "hoard.lua", {.duration = 0.5, .allocations = none}, {});
    QCOMPARE(deaf.failures(), std::vector<std::string>());
  }

  void a_worst_tick_beyond_its_period_is_a_warning() {
    Preflight slow;
    slow.run.threads.push_back({.name = "main", .rate = 1000.0});
    StepCost& cost = slow.run.threads.front().loop.tick_cost;
    cost.add(0, 5'000'000, 0);  // the first one is apart
    cost.add(1, 900'000, 0);
    QVERIFY(slow.warnings().empty());
    cost.add(2, 1'100'000, 0);
    QCOMPARE(slow.warnings(), std::vector<std::string>{
                                  "tick 2 of the thread main took 1100 µs here, longer than its "
                                  "period of 1000 µs"});
    QVERIFY(slow.failures().empty());
  }

  void a_sound_script_passes() {
    const Ran ran = run_trocar({"check", "sound.lua", "--preflight", "--for", "2s"});
    QCOMPARE(ran.err, QByteArray());
    QVERIFY2(ran.status == 0, ran.out);
    QVERIFY2(ran.out.startsWith("sound.lua: 2 s in virtual time\n"), ran.out);
    for (const char* part : {"laparoscope.device", "tick, of 1000", "wall.force",
                             "laparoscope.tool.tip.velocity", "Nothing would trip."})
      QVERIFY2(ran.out.contains(part), ran.out);
    QVERIFY(!QFile::exists("sound.mcap"));
  }

  void programs_get_the_same() {
    const auto json = json_of(run_trocar({"check", "sound.lua", "--preflight", "--for", "2s",
                                          "--set", "wall.stiffness=2 N/mm", "--json"}));
    QVERIFY(!json.is_discarded());
    QVERIFY(json["sound"].get<bool>());
    const auto& thread = json["threads"][0];
    QCOMPARE(thread["ticks"].get<int>(), 2000);
    for (const auto& component : thread["components"])
      QCOMPARE(component["allocations"].get<int>(), 0);
    QVERIFY(thread["tick"]["worst"].get<double>() >= thread["tick"]["p99"].get<double>() * 0.9 ||
            thread["tick"]["first"].get<double>() > 0.0);
    bool force = false, effort = false;
    for (const auto& peak : json["peaks"]) {
      const std::string name = peak["name"].get<std::string>();
      if (name == "wall.force") force = peak["peak"].get<double>() > 1.0;
      if (name == "laparoscope.device.effort_sent.axis1")
        effort = peak["limit"].get<double>() > peak["peak"].get<double>();
    }
    QVERIFY(force && effort);
  }

  void a_script_that_trips_fails() {
    const Ran ran = run_trocar({"check", "stops.lua", "--preflight"});
    QVERIFY2(ran.status == 1, ran.out + ran.err);
    QVERIFY2(ran.out.contains("1 s in virtual time"), ran.out);  // as its first run says
    QVERIFY2(ran.out.contains("Failures\n"), ran.out);
    QVERIFY2(ran.out.contains("at tick 500"), ran.out);
  }

  void a_law_that_fails_is_named_and_its_memory_shown() {
    const Ran ran = run_trocar({"check", "fails.lua", "--preflight", "--for", "1s"});
    QVERIFY2(ran.status == 1, ran.out + ran.err);
    QVERIFY2(ran.out.contains("law.lua:3"), ran.out);
    QVERIFY2(ran.out.contains("law.script.allocations  "), ran.out);
    QVERIFY2(ran.out.contains("law.script.memory"), ran.out);
  }

  void mistakes_are_told_as_without_it() {
    const Ran ran = run_trocar({"check", "broken.lua", "--preflight"});
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.contains("broken.lua:2: there is no trocar.Wal"), ran.err);
    QCOMPARE(run_trocar({"check", "sound.lua", "--for", "2s"}).status, 2);
  }
};

QTEST_GUILESS_MAIN(TestPreflight)
#include "tst_preflight.moc"
