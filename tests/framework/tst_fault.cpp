// SPDX-License-Identifier: Apache-2.0
#include "framework/fault.hpp"

#include <QTest>
#include <set>

using namespace trocar;

class TestFault : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_first_cause_stays_first_and_the_rest_is_listed() {
    FaultLatch latch;
    QVERIFY(!latch.latched());
    latch.raise({.cause = FaultCause::speed, .component = "arm", .value = 2.0, .tick = 7});
    latch.raise({.cause = FaultCause::workspace, .component = "arm", .tick = 7});
    latch.raise({.cause = FaultCause::speed, .component = "arm", .value = 9.0, .tick = 8});
    QVERIFY(latch.latched());
    QCOMPARE(latch.size(), std::size_t{2});
    QCOMPARE(latch[0].cause, FaultCause::speed);
    QCOMPARE(latch[0].tick, std::int64_t{7});
    QCOMPARE(latch[0].value, 2.0);
    QCOMPARE(latch[1].cause, FaultCause::workspace);
  }

  void the_same_cause_of_another_component_counts() {
    static const char* const names[] = {"a", "b"};
    FaultLatch latch;
    for (const char* name : names) latch.raise({.component = name});
    QCOMPARE(latch.size(), std::size_t{2});
  }

  void beyond_its_size_faults_are_counted() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < FaultLatch::capacity + 5; ++i) names.push_back(std::to_string(i));
    FaultLatch latch;
    for (const std::string& name : names) latch.raise({.component = name.c_str()});
    QCOMPARE(latch.size(), FaultLatch::capacity);
    QCOMPARE(latch.raised(), FaultLatch::capacity + 5);
    QCOMPARE(std::string(latch[0].component), std::string("0"));
  }

  void faults_beyond_its_size_can_be_acknowledged() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < FaultLatch::capacity + 5; ++i) names.push_back(std::to_string(i));
    FaultLatch latch;
    for (const std::string& name : names) latch.raise({.component = name.c_str()});
    latch.acknowledge();
    QVERIFY(!latch.latched());
    latch.raise({.component = "one more"});
    QVERIFY(latch.latched());
  }

  void every_cause_has_a_name_of_its_own() {
    std::set<std::string> names;
    for (int i = 0; i <= static_cast<int>(FaultCause::operator_stop); ++i)
      names.insert(to_string(static_cast<FaultCause>(i)));
    QCOMPARE(names.size(), static_cast<std::size_t>(FaultCause::operator_stop) + 1);
    QVERIFY(!names.contains("unknown"));
  }
};

QTEST_APPLESS_MAIN(TestFault)
#include "tst_fault.moc"
