// SPDX-License-Identifier: Apache-2.0
// A law is exchanged while it runs: what takes over, what is refused, what is undone, and that
// nobody feels a step.
#include <QDir>

#include "framework/recording/mcap_reader.hpp"
#include "framework/scripting/lua_component.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/law_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

/// A spring along z that counts its steps, in a version of its own.
QByteArray spring(const char* stiffness, const char* more = "") {
  return QByteArray(
             "return trocar.fixture {\n"
             "  parameters = { offset = { \"0 mm\" } },\n"
             "  outputs = { count = \"\", depth = \"m\" },\n"
             "  state = { count = 0, seen = false },\n"
             "  step = function(p, at, out, state, tick)\n"
             "    state.count = state.count + 1\n"
             "    out.count = state.count\n"
             "    out.depth = at.position.z - 0.085 + p.offset\n"
             "    ") +
         more + "\n    out.force:set(0, 0, -" + stiffness + " * out.depth)\n  end }\n";
}

/// Runs a law at a tool that a hand pushes; `files` replace it at their times.
struct Reloaded {
  struct Version {
    const char* at;
    QByteArray text;
  };

  Reloaded(const QByteArray& law, const std::vector<Version>& versions,
           const QByteArray& more_options = "duration = \"2 s\"", const QString& record = {},
           SessionOptions options = {}, ClockKind clock = ClockKind::simulated) {
    const auto write = [&](const QString& name, const QByteArray& text) {
      QFile file(folder.filePath(name));
      return file.open(QFile::WriteOnly) && file.write(text) == text.size();
    };
    QByteArray reloads;
    for (std::size_t i = 0; i < versions.size(); ++i) {
      const QString name = QString("law_%1.lua").arg(i + 2);
      if (!write(name, versions[i].text)) return;
      reloads +=
          QByteArray("{ at = \"") + versions[i].at + "\", law = \"" + name.toUtf8() + "\" },";
    }
    write("law.lua", law);
    write("script.lua",
          "local laparoscope = trocar.Laparoscope { hand = \"push\", [\"device.push_distance\"] = "
          "\"30 mm\" }\n"
          "trocar.LuaFixture { file = \"law.lua\", at = laparoscope.tip }\n"
          "local run = trocar.run { reloads = {" +
              reloads + "}, " + more_options + " }\n");
    if (!record.isEmpty()) options.record = record.toStdString();
    outcome = run_script_file(folder.filePath("script.lua"), {}, std::move(options), clock);
  }

  const RunResult& run() const { return outcome.session->runs().back()->result; }
  std::vector<double> column(const char* name) const {
    return run().rows->column(*run().rows->find(name));
  }
  QString trouble(std::size_t i = 0) const {
    return QString::fromStdString(run().reloads.at(i).trouble);
  }
  double largest_step(const std::vector<double>& values) const {
    double largest = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i)
      largest = std::max(largest, std::abs(values[i] - values[i - 1]));
    return largest;
  }

  QTemporaryDir folder;
  ScriptOutcome outcome;
};

}  // namespace

class TestLawReload : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_new_version_takes_over_with_the_state() {
    const Reloaded law(spring("500"), {{"1 s", spring("600")}});
    QVERIFY(law.outcome.findings.isEmpty());
    QVERIFY(law.run().faults.empty());
    QCOMPARE(law.run().reloads.size(), std::size_t{1});
    QCOMPARE(law.trouble(), QString());
    const std::vector<double> count = law.column("law.count");
    for (std::size_t i = 0; i < count.size(); ++i) QCOMPARE(count[i], static_cast<double>(i + 1));
    const std::vector<double> force = law.column("law.force.z"), depth = law.column("law.depth");
    QVERIFY(std::abs(force[999] + 500.0 * depth[999]) < 1e-12);
    QVERIFY(std::abs(force[1300] + 600.0 * depth[1300]) < 1e-12);
  }

  void nobody_feels_a_step() {
    const Reloaded law(spring("500"), {{"1.5 s", spring("600")}});
    const std::vector<double> force = law.column("law.force.z"), depth = law.column("law.depth");
    const double difference = 100.0 * std::abs(depth[1500]);
    QVERIFY(difference > 0.1);
    double largest = 0.0;
    for (std::size_t i = 1500; i < 1750; ++i)
      largest = std::max(largest, std::abs(force[i] - force[i - 1]));
    const Reloaded without(spring("500"), {});
    // The ramp's slope, the motion itself, and what the changed force makes of it.
    QVERIFY2(
        largest <= 1.5 * difference / 200.0 + without.largest_step(without.column("law.force.z")),
        qPrintable(QString::number(largest)));
  }

  void what_is_wrong_is_refused_and_the_old_law_goes_on_data() {
    QTest::addColumn<QByteArray>("next");
    QTest::addColumn<QString>("trouble");
    const auto row = [](const char* name, const QByteArray& next, const char* trouble) {
      QTest::newRow(name) << next << QString(trouble);
    };
    row("no Lua", "return trocar.fixture {", "law_2.lua:1");
    row("fails on what was seen", spring("600", "if state.count > 700 then error('no') end"),
        "(on what it saw at tick");
    row("an endless loop", spring("600", "while true do end"), "instructions");
    row("not finite", spring("(0/0)"), "is not finite");
    row("another output",
        QByteArray(spring("600")).replace("depth = \"m\"", "depth = \"mm\", more = \"m\""),
        "the output \"more\" is new");
    row("an output less",
        QByteArray(spring("600"))
            .replace("count = \"\", ", "")
            .replace("out.count = state.count", ""),
        "the output \"count\" has gone");
    row("another parameter",
        QByteArray(spring("600"))
            .replace("offset = { \"0 mm\" }", "offset = { \"0 mm\" }, gain = { 2 }"),
        "the parameter \"gain\" is new");
    row("a parameter of another type",
        QByteArray(spring("600")).replace("offset = { \"0 mm\" }", "offset = { \"0 N\" }"),
        "the parameter \"offset\" is new, or of another type");
  }
  void what_is_wrong_is_refused_and_the_old_law_goes_on() {
    QFETCH(QByteArray, next);
    QFETCH(QString, trouble);
    const Reloaded law(spring("500"), {{"1 s", next}});
    QVERIFY(law.run().faults.empty());
    QVERIFY2(law.trouble().contains(trouble), qPrintable(law.trouble()));
    QCOMPARE(law.column("law.force.z"), Reloaded(spring("500"), {}).column("law.force.z"));
  }

  void a_force_that_would_step_is_undone() {
    const Reloaded law(spring("500"), {{"1.5 s", spring("5000")}});
    QVERIFY2(law.trouble().contains("its force differs too much"), qPrintable(law.trouble()));
    QVERIFY(law.run().faults.empty());
    const std::vector<double> force = law.column("law.force.z"), depth = law.column("law.depth");
    QVERIFY(std::abs(force.back() + 500.0 * depth.back()) < 1e-12);
  }

  void trouble_within_the_probation_brings_the_old_law_back() {
    const Reloaded law(
        spring("500"),
        {{"1 s", spring("600", "if tick.time > 1.5 then error('late trouble') end")}});
    QVERIFY2(law.trouble().contains("late trouble"), qPrintable(law.trouble()));
    QVERIFY(law.run().faults.empty());
    const std::vector<double> force = law.column("law.force.z"), depth = law.column("law.depth");
    QVERIFY(std::abs(force[1490] + 600.0 * depth[1490]) < 1e-12);
    QVERIFY(std::abs(force.back() + 500.0 * depth.back()) < 1e-12);
    const std::vector<double> count = law.column("law.count");
    QVERIFY(count.back() >= 1999.0);  // the state came back with it
    QVERIFY(law.largest_step(force) < 0.05);
  }

  void trouble_after_it_is_a_fault() {
    const Reloaded law(spring("500"),
                       {{"0.5 s", spring("600", "if tick.time > 1.8 then error('too late') end")}});
    QCOMPARE(law.run().faults.size(), std::size_t{1});
    QVERIFY(QString::fromStdString(law.run().faults.front().detail).contains("too late"));
  }

  void a_thousand_reloads_lose_no_tick_and_no_memory() {
#if defined(__SANITIZE_THREAD__)
    constexpr int many = 100;  // minutes otherwise, in which the same two threads meet
#else
    constexpr int many = 1000;
#endif
    std::vector<Reloaded::Version> versions;
    std::vector<QByteArray> times;
    for (int i = 0; i < many; ++i)
      times.push_back(QByteArray::number(20 + 4000 / many * i) + " ms");
    for (int i = 0; i < many; ++i)
      versions.push_back(
          {times[static_cast<std::size_t>(i)].constData(), spring(i % 2 == 0 ? "600" : "500")});
    const Reloaded law(spring("500"), versions, "duration = \"5 s\"");
    QCOMPARE(law.run().reloads.size(), std::size_t{many});
    for (std::size_t i = 0; i < many; ++i) QCOMPARE(law.trouble(i), QString());
    QVERIFY(law.run().faults.empty());
    const std::vector<double> count = law.column("law.count");
    QCOMPARE(count.size(), std::size_t{5000});
    for (std::size_t i = 0; i < count.size(); ++i) QCOMPARE(count[i], static_cast<double>(i + 1));
    // Each ramp begins where the one before left the force, with the difference of the laws at
    // most.
    const std::vector<double> force = law.column("law.force.z"), depth = law.column("law.depth");
    double largest = 0.0, slope = 0.0;
    for (std::size_t i = 1; i < force.size(); ++i) {
      const double motion = 600.0 * std::abs(depth[i] - depth[i - 1]);
      largest = std::max(largest, std::abs(force[i] - force[i - 1]) - motion);
      slope = std::max(slope, 100.0 * std::abs(depth[i]) / 200.0);
    }
    qInfo("%d reloads: largest step beyond the motion's %.3g N, the ramp's slope %.3g N a tick",
          many, largest, slope);
    QVERIFY(slope > 1e-3);
    QVERIFY(largest <= 1.01 * slope);
  }

  void two_runs_with_reloads_give_the_same_bytes() {
    const auto bytes = [](const QString& path) {
      QFile file(path);
      return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QTemporaryDir folder;
    for (const char* name : {"a.mcap", "b.mcap"})
      Reloaded(spring("500"), {{"0.5 s", spring("600")}, {"1 s", spring("(0/0)")}},
               "duration = \"2 s\", edits = { { at = \"0.7 s\", [\"law.offset\"] = \"1 mm\" } }",
               folder.filePath(name));
    QVERIFY(bytes(folder.filePath("a.mcap")).size() > 10'000);
    QVERIFY(bytes(folder.filePath("a.mcap")) == bytes(folder.filePath("b.mcap")));
  }

  void the_texts_are_in_the_log() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("log.mcap");
    Reloaded(spring("500"), {{"0.5 s", spring("600")}, {"1 s", spring("(0/0)")}},
             "duration = \"2 s\"", path);
    const McapReader log(path.toStdString());
    const auto text = [&](const std::string& name) {
      for (const McapAttachment& one : log.attachments())
        if (one.name == name) {
          const std::vector<std::byte> bytes = log.read(one);
          return QByteArray(reinterpret_cast<const char*>(bytes.data()),
                            static_cast<qsizetype>(bytes.size()));
        }
      return QByteArray();
    };
    QCOMPARE(text("run1.reload1.law_2.lua"), spring("600"));
    QCOMPARE(text("run1.reload2.law_3.lua"), spring("(0/0)"));
  }

  /// What the loop does of it: take over, ramp, prove itself, or go back.
  void the_loop_allocates_nothing_for_it() {
    Findings findings;
    const auto file = lua::read_law(lua::LawKind::fixture, "law.lua", "law.lua",
                                    spring("500").toStdString(), findings);
    QVERIFY2(file, findings.by_line().text().c_str());
    lua::LuaComponent law(file);
    law.set_name("law");
    law.configure({.period = 1e-3, .seed = 1, .virtual_time = true, .reloadable = true});
    law.start();
    std::int64_t index = 0;
    const auto steps = [&](int count) {
      for (int i = 0; i < count; ++i, ++index) {
        law.step({.index = index, .time = static_cast<double>(index) * 1e-3, .dt = 1e-3});
        law.use_slack();
      }
    };
    steps(100);
    const auto next = law.prepare({.text = spring("510").toStdString()});
    const auto farther = law.prepare({.text = spring("5000").toStdString()});
    std::vector<Event::Kind> news;
    news.reserve(4);
    const int allocations = allocations_in([&] {
      Event event;
      law.replace(*next);
      steps(1100);
      while (law.take_news(event)) news.push_back(event.kind);
      law.replace(*farther);
      steps(1);
      while (law.take_news(event)) news.push_back(event.kind);
      steps(300);
    });
    QCOMPARE(allocations, 0);
    QCOMPARE(news, (std::vector{Event::Kind::reloaded, Event::Kind::reload_undone}));
    QVERIFY(farther->released() && !next->released());
    QVERIFY(law.failure() == nullptr);
  }

  /// Versions are made ready and freed by one thread while another steps.
  void in_real_time_another_thread_makes_them_ready() {
    const Reloaded law(spring("500"),
                       {{"150 ms", spring("500")},  // not in the order of their times
                        {"50 ms", spring("510")},
                        {"100 ms", spring("(0/0)")},
                        {"200 ms", spring("510")},
                        {"50 s", spring("520")}},
                       "duration = \"0.4 s\", rate = \"200 Hz\", set = { [\"law.deadline\"] = "
                       "\"4 ms\" }",
                       {}, {}, ClockKind::realtime);
    QVERIFY2(law.outcome.findings.isEmpty(), qPrintable(law.outcome.findings.join('\n')));
    QVERIFY(law.run().clock == ClockKind::realtime);
    QCOMPARE(law.run().reloads.size(), std::size_t{5});
    QVERIFY2(law.trouble(2).contains("is not finite"), qPrintable(law.trouble(2)));
    QCOMPARE(law.trouble(4), QString("the run ended before"));
    QVERIFY(law.run().reloads[1].time < law.run().reloads[2].time);
    QVERIFY(law.run().reloads[2].time < law.run().reloads[0].time);
  }

  void one_that_the_run_does_not_reach_is_told() {
    const Reloaded law(spring("500"), {{"1 s", spring("600")}, {"3 s", spring("700")}});
    QCOMPARE(law.run().reloads.size(), std::size_t{2});
    QCOMPARE(law.trouble(0), QString());
    QCOMPARE(law.trouble(1), QString("the run ended before"));
  }

  void a_component_without_a_law_is_named_before_the_run_data() {
    QTest::addColumn<ClockKind>("clock");
    QTest::newRow("virtual time") << ClockKind::simulated;
    QTest::newRow("real time") << ClockKind::realtime;
  }
  void a_component_without_a_law_is_named_before_the_run() {
    QFETCH(ClockKind, clock);
    const ScriptOutcome outcome = run_script_text(
        "local sine = trocar.Sine { amplitude = \"1 N\", frequency = \"1 Hz\" }\n"
        "trocar.run { reloads = { { at = \"1 s\", sine = \"script.lua\" } } }\n",
        {}, {}, clock);
    QVERIFY2(outcome.findings.join('\n').contains("\"sine\" cannot be reloaded"),
             qPrintable(outcome.findings.join('\n')));
  }
};

QTEST_GUILESS_MAIN(TestLawReload)
#include "tst_law_reload.moc"
