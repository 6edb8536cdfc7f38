// SPDX-License-Identifier: Apache-2.0
// Specs: which tests a file has, when one passes, and what the others are told.
#include "framework/scripting/spec.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "components/register.hpp"

using namespace trocar;

class TestSpec : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  Registry registry_;

  std::string write(const char* name, const QByteArray& text) {
    QFile file(folder_.filePath(name));
    if (!file.open(QFile::WriteOnly) || file.write(text) != text.size()) return "";
    return file.fileName().toStdString();
  }
  std::string spec(const QByteArray& text) { return write("a_spec.lua", text); }
  /// A spec of one test, with a run of a wall against which a hand pushes, up to 6.9 N.
  std::vector<SpecFailure> outcome(const QByteArray& body) {
    const QByteArray text =
        "local rig = trocar.load(\"wall.lua\", { [\"wall.stiffness\"] = \"1 N/mm\" })\n"
        "local run = rig:run { duration = \"2 s\" }\n"
        "local force = run[\"wall.force.z\"]\n"
        "it(\"does\", function() " +
        body + "\nend)\n";
    return run_spec(registry_, spec(text), 0);
  }

 private Q_SLOTS:
  void initTestCase() {
    register_components(registry_);
    QVERIFY(
        !write("wall.lua",
               "local laparoscope = trocar.Laparoscope { hand = trocar.args.hand or \"push\" }\n"
               "trocar.Wall { at = laparoscope.tip, point = { 0, 0, \"105 mm\" },\n"
               "  normal = { 0, 0, -1 } }\n")
             .empty());
    QVERIFY(!write("experiment.lua",
                   "local laparoscope = trocar.Laparoscope { hand = \"none\" }\n"
                   "for i = 1, 2 do\n"
                   "  local run = trocar.run { duration = \"10 ms\", rate = \"2 kHz\" }\n"
                   "  trocar.publish(\"row\", { i = i, ticks = run.ticks })\n"
                   "end\n")
                 .empty());
  }

  void a_file_has_its_tests_in_order() {
    const std::string path = spec(
        "describe(\"a\", function()\n it(\"b\", error)\n describe(\"c\", function()\n"
        "  it(\"d\", error)\n end)\nend)\nit(\"e\", error)\n");
    const std::vector<SpecTest> tests = list_spec(registry_, path);
    QCOMPARE(tests.size(), 3U);
    QCOMPARE(tests[0].name, "a: b");
    QCOMPARE(tests[1].name, "a: c: d");
    QCOMPARE(tests[2].name, "e");
    QCOMPARE(tests[1].where, (Where{path, 4}));
  }

  void a_broken_file_says_where() {
    const std::string path = spec("describe(\"a\", function()\n local x = nil + 1\nend)\n");
    try {
      list_spec(registry_, path);
      QFAIL("it is read");
    } catch (const BrokenGraph& broken) {
      QCOMPARE(broken.findings.all().front().where, (Where{path, 2}));
    }
    QVERIFY_THROWS_EXCEPTION(BrokenGraph,
                             list_spec(registry_, folder_.filePath("none").toStdString()));
    QVERIFY_THROWS_EXCEPTION(BrokenGraph, list_spec(registry_, spec("it(\"no function\")")));
    QVERIFY_THROWS_EXCEPTION(BrokenGraph, list_spec(registry_, spec("trocar.Wal {}")));
  }

  void tests_leave_nothing_behind() {
    const std::string path = spec(
        "count = 0\nlocal n = 0\n"
        "before_each(function() n = n + 1 end)\n"
        "describe(\"inner\", function()\n"
        "  it(\"a\", function() n = n + 10; count = count + 1; expect(n):equals(111) end)\n"
        "  before_each(function() n = n + 100 end)\n"
        "  it(\"b\", function() n = n + 10; count = count + 1; expect(n):equals(111) end)\n"
        "end)\n"
        "it(\"c\", function() expect(n):equals(1); expect(count):equals(0) end)\n");
    for (std::size_t test = 0; test < 3; ++test) {
      const auto failures = run_spec(registry_, path, test);
      QVERIFY2(failures.empty(), failures.empty() ? "" : failures.front().text().c_str());
    }
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, run_spec(registry_, path, 3));
  }

  void it_passes_data() {
    QTest::addColumn<QByteArray>("body");
    const auto row = [](const char* name, const char* body) {
      QTest::newRow(name) << QByteArray(body);
    };
    row("always", "expect(force):always('<=', 0)");
    row("always from a time on", "expect(force):always('<', '-5 N', { from = '1.6 s' })");
    row("always up to a time", "expect(force):always('==', '0 N', { to = '0.5 s' })");
    row("eventually", "expect(force):eventually('<', '-6 N', { before = '1.8 s' })");
    row("within", "expect(force):within('-7 N', '0 N')");
    row("settles, in a band of its own", "expect(force):settles('-6.9 N', { before = '1.9 s' })");
    row("settles", "expect(force):settles('-6.9 N', { within = '0.1 N' })");
    row("peaks", "expect(force):peaks('-6.9 N', { within = '1 %' })");
    row("crosses", "expect(force):crosses('-1 N', { times = 1, way = 'down', before = '1.5 s' })");
    row("never crosses", "expect(force):crosses('1 N', { times = 0 })");
    row("a length", "expect(run['wall.force']:norm()):always('<=', '7 N')");
    row("true and false",
        "local device = trocar.Laparoscope { hand = 'none' }\n"
        "trocar.Staircase { at = device.incision, peak = '4 N', levels = 3 }\n"
        "expect(trocar.run { duration = '1 s' }['staircase.settled']):eventually('==', false)");
    row("energy",
        "expect(run['wall.force']):energy('<=', '1 uJ',"
        " { velocity = run['laparoscope.tool.tip.velocity'] })");
    row("equals", "expect({ 1, a = { 'x' } }):equals({ 1, a = { 'x' } })");
    row("is", "expect(run.ticks):is('==', 2000)");
    row("near", "expect(run:min(force)):near('-6.9 N', { within = '1 %' })");
    row("empty", "expect(run.faults):empty() expect(''):empty()");
    row("contains", "expect('a wall'):contains('wall') expect({ 'a wall' }):contains('wall')");
    row("fails", "expect(function() trocar.load('none.lua') end):fails('can be read')");
    row("a run of its own",
        "trocar.Constant { value = '2 N' }\n"
        "local own = trocar.run { duration = '10 ms', rate = '2 kHz' }\n"
        "expect(own['constant.value']):always('==', '2 N') expect(own.ticks):equals(20)");
    row("a loaded script runs as its first run, with other settings",
        "local rig = trocar.load('experiment.lua')\n"
        "expect(rig:run().ticks):equals(20) expect(rig:run { rate = '1 kHz' }.ticks):equals(10)");
    row("a loaded script's arguments",
        "local rig = trocar.load('wall.lua', { hand = 'none' })\n"
        "expect(rig:run { duration = '2 s' }['wall.force.z']):always('==', 0)");
    row("an experiment",
        "local done = trocar.experiment('experiment.lua')\n"
        "expect(#done.runs):equals(2)\n"
        "expect(done.published.row):equals({ { i = 1, ticks = 20 }, { i = 2, ticks = 20 } })");
    row("a fault that is expected",
        "local stopped = rig:run { duration = '1 s', requests = { { at = '0.5 s', ask = 'stop' } } "
        "}\n"
        "expect(stopped.faults):contains('operator')");
  }
  void it_passes() {
    QFETCH(QByteArray, body);
    const auto failures = outcome(body);
    QVERIFY2(failures.empty(), failures.empty() ? "" : failures.front().text().c_str());
  }

  void it_fails_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<QByteArray>("text");  // of the report
    const auto row = [](const char* name, const char* body, const char* text) {
      QTest::newRow(name) << QByteArray(body) << QByteArray(text);
    };
    row("always", "expect(force):always('>=', '-5 N')", "wall.force.z >= -5 N, always");
    row("always says how often", "expect(force):always('>', '-1000 mN', { from = '1.5 s' })",
        "and so in 500 of 500 rows (tick 1500)");
    row("eventually", "expect(force):eventually('<', '-6 N', { before = '1 s' })",
        "got       not until -6.0");
    row("eventually never", "expect(force):eventually('>', '1 N')", "at most near it: 0 N at 0 s");
    row("within", "expect(force):within('-5 N', '0 N')", "wall.force.z within -5 N and 0 N");
    row("within the wrong way", "expect(force):within('0 N', '-5 N')",
        "the lower bound comes first");
    row("settles", "expect(force):settles('0 N')", "got       at the end -6.9");
    row("settles too late", "expect(force):settles('-6.9 N', { before = '1 s' })", "there from 1.");
    row("peaks", "expect(force):peaks('-4 N', { within = '0.1 N' })", "-4 N ± 0.1 N");
    row("crosses", "expect(force):crosses('-1 N', { times = 2 })", "got       1 times, at 1.");
    row("never crosses", "expect(force):crosses('1 N')", "got       never");
    row("energy",
        "expect(run['wall.force']):energy('>', 0,"
        " { velocity = run['laparoscope.tool.tip.velocity'] })",
        "energy given by wall.force > 0 J, always");
    row("a wrong unit", "expect(force):always('<', '5 mm')", "wall.force.z needs N, e.g. \"1 N\"");
    row("a bare number", "expect(force):always('<', 5)", "always = 5: wall.force.z needs N");
    row("a comparison that is none", "expect(force):always('=<', 0)", "needs one of <  <=  ==");
    row("an option that is none", "expect(force):always('<', '1 N', { form = '1 s' })",
        "always has no \"form\", did you mean \"from\"?");
    row("a time without rows", "expect(force):always('<', '1 N', { from = '5 s' })",
        "has no row between");
    row("a vector", "expect(run['wall.force']):always('<', '1 N')",
        "\"wall.force\" has 3 numbers: name one of them");
    row("a signal that is none", "expect(run['wall.forc.z']):always('<', '1 N')",
        "no signal \"wall.forc.z\", did you mean \"wall.force.z\"?");
    row("a method that is none", "expect(force):alway('<', '1 N')", "did you mean \"always\"?");
    row("a dot", "expect(force).always('<', '1 N')", "a method is called with a colon");
    row("a signal's method on a number", "expect(5):always('<', '1 N')", "is for signals");
    row("equals", "expect({ 1, 2 }):equals({ 1, 3 })", "expected  {1, 3}");
    row("is", "expect(5):is('<', 5)", "expected  < 5");
    row("near", "expect(5):near('6 N', { within = '0.5 N' })", "got       5, 1 away");
    row("near without within", "expect(5):near(6)", "near needs within");
    row("not a number", "expect(0 / 0):is('<', 1)", "nan");
    row("empty", "expect({ 1 }):empty()", "expected  empty");
    row("contains", "expect({ 'a' }):contains('b')", "expected  contains \"b\"");
    row("fails", "expect(function() end):fails('why')", "got       no error");
    row("an error", "local x = nil + 1", "attempt to perform arithmetic");
    row("an expectation caught by pcall", "pcall(function() expect(1):equals(2) end)",
        "expected  2");
    row("an expectation within fails",
        "expect(function() expect(1):equals(2) end):fails('expected')", "expected  2");
    row("nothing expected", "", "the test expects nothing");
    row("a mistake in a graph", "trocar.Wal {} expect(1):equals(1)", "there is no trocar.Wal");
    row("a mistake in a loaded script", "trocar.load('wall.lua', { ['wal.stiffness'] = '1 N/mm' })",
        "did you mean \"wall.stiffness\"?");
    row("a fault that nobody looked at",
        "rig:run { duration = '1 s', requests = { { at = '0.5 s', ask = 'stop' } } }\n"
        "expect(1):equals(1)",
        "a run had a fault, and the test never looked at its `faults`");
    row("a plain script as an experiment", "trocar.experiment('wall.lua')", "is no experiment");
    row("describe in a test", "describe('x', function() end)", "describe is for the outside");
  }
  void it_fails() {
    QFETCH(QByteArray, body);
    QFETCH(QByteArray, text);
    const auto failures = outcome(body);
    QCOMPARE(failures.size(), 1U);
    const std::string told = failures.front().text();
    QVERIFY2(QByteArray::fromStdString(told).contains(text), told.c_str());
    QVERIFY2(failures.front().where.line >= 4, told.c_str());
  }

  void a_signals_failure_shows_the_signal() {
    const SpecFailure failure = outcome("expect(force):always('>=', '-5 N')").front();
    QVERIFY(failure.tick > 1000 && failure.tick < 2000);
    const QString plot = QString::fromStdString(failure.plot);
    QVERIFY2(plot.contains("▲") && plot.contains("-5 N │") && plot.contains("╌"), qPrintable(plot));
    const double time = 0.001 * static_cast<double>(failure.tick);
    QVERIFY2(plot.contains(QString("%1 s").arg(time)), qPrintable(plot));
  }

  void the_seed_of_the_command_wins() {
    const std::string path = spec(
        "local first = math.random()\nit(\"a\", function()\n"
        "  math.randomseed(5) expect(first):equals(math.random()) end)\n");
    QVERIFY(run_spec(registry_, path, 0, {.seed = 5}).empty());
    QVERIFY(!run_spec(registry_, path, 0, {.seed = 6}).empty());
  }
};

QTEST_GUILESS_MAIN(TestSpec)
#include "tst_spec.moc"
