// SPDX-License-Identifier: Apache-2.0
// Time series in scripts: run:samples, run:discard and trocar.least_squares.
#include "tests/support/script_bench.hpp"

using namespace trocar;
using test::run_script_text;
using test::ScriptOutcome;

namespace {

const QByteArray scene =
    "local sine = trocar.Sine { amplitude = \"2 N\", frequency = \"1 Hz\" }\n"
    "local course = trocar.ShuttleMotion { stroke = \"10 mm\", speed = \"0.05 m/s\",\n"
    "  turning = \"1 m/s^2\" }\n"
    "local run = trocar.run { duration = \"1 s\" }\n";

}  // namespace

class TestSamples : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void all_rows_or_some_of_them() {
    const ScriptOutcome outcome = run_script_text(
        scene +
            "local all = run:samples(sine.value)\n"
            "assert(#all == run.ticks and all[1] == 0 and math.abs(all[251] - 2) < 1e-9)\n"
            "local some = run:samples(\"sine.value\", { from = \"0.25 s\", to = \"0.75 s\", every "
            "= "
            "50 })\n"
            "assert(#some == 11 and some[1] == all[251] and some[11] == all[751])\n"
            "local steady = run:samples(course.velocity.z, { where = course.steady })\n"
            "assert(#steady > 100 and #steady < #all)\n"
            "for _, v in ipairs(steady) do assert(math.abs(v) == 0.05) end\n",
        {}, {.duration = 1.0});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
  }

  void a_run_keeps_what_is_asked_for() {
    const ScriptOutcome outcome = run_script_text(
        scene +
            "local whole = { run:samples(sine.value), run:samples(course.offset.z) }\n"
            "local steady = run:samples(course.steady)\n"
            "local less = trocar.run { duration = \"1 s\", keep = { sine.value, course.offset,\n"
            "  \"shuttle_motion.steady\" } }\n"
            "for i, v in ipairs(less:samples(sine.value)) do assert(v == whole[1][i]) end\n"
            "for i, v in ipairs(less:samples(course.offset.z)) do assert(v == whole[2][i]) end\n"
            "for i, v in ipairs(less:samples(course.steady)) do assert(v == steady[i]) end\n"
            "assert(less:at(sine.value, \"0.25 s\") == run:at(sine.value, \"0.25 s\"))\n"
            "assert(not pcall(less.samples, less, course.velocity.z))\n"
            "local ok, said = pcall(trocar.run, { duration = \"1 s\", keep = { \"sine.valu\" } })\n"
            "assert(not ok and said:find('no signal \"sine.valu\", did you mean \"sine.value\"'), "
            "said)\n",
        {}, {.duration = 1.0});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
  }

  void a_discarded_run_has_no_rows_left() {
    const ScriptOutcome outcome = run_script_text(
        scene + "run:discard()\nassert(#run:samples(sine.value) == 0 and run.ticks > 0)\n", {},
        {.duration = 1.0});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
  }

  void least_squares_of_samples() {
    const ScriptOutcome outcome = run_script_text(
        scene +
            "local x, ones, y = run:samples(sine.value, { every = 10 }), {}, {}\n"
            "for i, v in ipairs(x) do ones[i] = 1; y[i] = 3 * v - 0.5 end\n"
            "local fit = trocar.least_squares { columns = { x, ones }, target = y }\n"
            "assert(math.abs(fit.solution[1] - 3) < 1e-9 and math.abs(fit.solution[2] + 0.5) < "
            "1e-9)\n"
            "assert(fit.rms < 1e-9 and fit.r2 > 1 - 1e-9 and #fit.errors == 2)\n",
        {}, {.duration = 1.0});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
  }

  void mistakes_are_named_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QString>("said");
    QTest::newRow("no such signal") << QByteArray("run:samples(\"sine.valu\")")
                                    << "no signal \"sine.valu\", did you mean \"sine.value\"?";
    QTest::newRow("three numbers")
        << QByteArray("run:samples(course.offset)") << "\"shuttle_motion.offset\" has 3 numbers";
    QTest::newRow("every half row") << QByteArray("run:samples(sine.value, { every = 0.5 })")
                                    << "every = 0.5: needs a whole number";
    QTest::newRow("no table") << QByteArray("run:samples(sine.value, 3)")
                              << "takes a signal and a table";
    QTest::newRow("no columns") << QByteArray("trocar.least_squares { target = { 1 } }")
                                << "needs columns";
    QTest::newRow("a text among numbers")
        << QByteArray("trocar.least_squares { columns = { { 1, \"2\" } }, target = { 1, 2 } }")
        << "column 1: entry 2 is no number";
    QTest::newRow("too short")
        << QByteArray("trocar.least_squares { columns = { { 1 } }, target = { 1, 2 } }")
        << "column 1 has 1 rows, the target 2";
  }
  void mistakes_are_named() {
    QFETCH(QByteArray, line);
    QFETCH(QString, said);
    const ScriptOutcome outcome = run_script_text(scene + line + '\n', {}, {.duration = 0.1});
    QCOMPARE(outcome.findings.size(), 1);
    QVERIFY2(outcome.findings[0].startsWith("5: ") && outcome.findings[0].contains(said),
             qPrintable(outcome.findings[0]));
  }
};

QTEST_GUILESS_MAIN(TestSamples)
#include "tst_samples.moc"
