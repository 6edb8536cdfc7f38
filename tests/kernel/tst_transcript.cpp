// SPDX-License-Identifier: Apache-2.0
#include "tests/kernel/transcript.hpp"

#include <QTest>

using namespace trocar::test;

class TestTranscript : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void lines_and_files_are_sorted() {
    const Transcript all = transcript_of(
        "[ 1.0] the kernel's\n@kernel 6.1 #1\n@rate 500\n@asked jump 3.25\n"
        "@state jump fault of encoder jump, tip\n@begin a.json\n{\n\"x\": 1 }\n\n@end a.json\n"
        "between\n@failed: it does not hold: ready\n");
    QCOMPARE(all.kernel, std::string("6.1 #1"));
    QCOMPARE(all.rate, 500.0);
    QCOMPARE(all.asked.at("jump"), 3.25);
    QCOMPARE(all.states.at("jump"), std::string("fault of encoder jump, tip"));
    QCOMPARE(all.json("a.json")["x"].get<int>(), 1);
    QVERIFY(all.json("b.json").is_discarded());
    QCOMPARE(all.failures.size(), std::size_t{1});
    QCOMPARE(all.failures[0], std::string("it does not hold: ready"));
    QVERIFY(!all.complete);
    QVERIFY(transcript_of("@done\n").complete);
  }

  void when_the_effort_ended_is_read() {
    const EffortZero zero = effort_zero(
        "ready, 7 commands taken, effort zero 6.25 ms after the last good report and 0.50 ms after "
        "the last command");
    QVERIFY(zero.said);
    QCOMPARE(zero.after_report, 6.25);
    QCOMPARE(zero.after_command, 0.5);
    QVERIFY(!effort_zero("engaged, 7 commands taken").said);
    QVERIFY(!effort_zero("ready, effort zero").said);
  }
};

QTEST_APPLESS_MAIN(TestTranscript)
#include "tst_transcript.moc"
