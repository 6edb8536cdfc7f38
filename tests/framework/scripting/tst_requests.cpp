// SPDX-License-Identifier: Apache-2.0
// An operator's requests in a script: `requests` of trocar.run.
#include "tests/support/script_bench.hpp"

using namespace trocar;
using test::run_script_text;
using test::ScriptOutcome;

namespace {

const QByteArray scene =
    "local laparoscope = trocar.Laparoscope { hand = \"firm\", ideal = true }\n"
    "local wall = trocar.Wall { at = laparoscope.tip, point = { 0, 0, \"105 mm\" },\n"
    "  normal = { 0, 0, -1 } }\n";

}  // namespace

class TestRequests : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void requests_act_at_their_time() {
    const ScriptOutcome outcome = run_script_text(
        scene +
            "local run = trocar.run { duration = \"4 s\", requests = {\n"
            "  { at = \"1.5 s\", ask = \"stop\" }, { at = \"2 s\", ask = \"acknowledge\" },\n"
            "  { at = \"2.1 s\", ask = \"engage\" } } }\n"
            "local sent = laparoscope.device.scale\n"
            "assert(#run.faults == 1, #run.faults)\n"
            "assert(run.faults[1]:find(\"operator stop in laparoscope.device at tick 1500\"))\n"
            "assert(run:at(sent, \"1.49 s\") == 1 and run:at(sent, \"1.5 s\") == 0)\n"
            "assert(run:at(sent, \"2.5 s\") == 0 and run:last(sent) == 1)\n",
        {}, {.duration = 4.0});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
  }

  void a_request_ends_the_run() {
    const ScriptOutcome outcome = run_script_text(
        scene +
            "local run = trocar.run { duration = \"2 s\", requests = { { at = \"0.25 s\", "
            "ask = \"end\" } } }\n"
            "assert(run.ticks == 251, run.ticks)\n",
        {}, {.duration = 2.0});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
  }

  void mistakes_are_named_data() {
    QTest::addColumn<QByteArray>("requests");
    QTest::addColumn<QString>("said");
    QTest::newRow("no list") << QByteArray("true") << "requests: needs a list";
    QTest::newRow("no time") << QByteArray("{ { ask = \"stop\" } }") << "requests: each needs at";
    QTest::newRow("nothing asked") << QByteArray("{ { at = \"1 s\" } }") << "requests: each needs";
    QTest::newRow("unknown")
        << QByteArray("{ { at = \"1 s\", ask = \"stpo\" } }")
        << "requests.ask = \"stpo\": stop, acknowledge, home, engage and end are, did "
           "you mean \"stop\"?";
    QTest::newRow("a number") << QByteArray("{ { at = \"1 s\", ask = 3 } }") << "requests.ask = 3:";
    QTest::newRow("another key") << QByteArray("{ { at = \"1 s\", aks = \"stop\" } }")
                                 << "requests: has no \"aks\", did you mean \"ask\"?";
  }
  void mistakes_are_named() {
    QFETCH(QByteArray, requests);
    QFETCH(QString, said);
    const ScriptOutcome outcome =
        run_script_text(scene + "trocar.run { requests = " + requests + " }\n");
    QCOMPARE(outcome.findings.size(), 1);
    QVERIFY2(outcome.findings[0].contains(said), qPrintable(outcome.findings[0]));
  }
};

QTEST_GUILESS_MAIN(TestRequests)
#include "tst_requests.moc"
