// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/report_faults.hpp"

#include <QTest>
#include <bit>
#include <cmath>

using namespace trocar::hid;

namespace {

Report numbered(std::uint8_t n) {
  Report report{};
  report[0] = n;
  return report;
}

int turned_bits(const Report& a, const Report& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += std::popcount(static_cast<unsigned>(a[i] ^ b[i]));
  return count;
}

bool about(int count, double expected) {
  return std::abs(count - expected) < 5.0 * std::sqrt(expected);
}

}  // namespace

class TestReportFaults : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void without_orders_all_arrive_at_once() {
    ReportFaults way(1);
    Report report;
    for (std::uint8_t n = 0; n < 200; ++n) {
      way.send(numbered(n), 1000u * n);
      QVERIFY(way.arrived(1000u * n, report));
      QVERIFY(report == numbered(n));
      QVERIFY(!way.arrived(1000u * n, report));
    }
  }

  void a_delay_keeps_the_order_and_wraps_with_the_time() {
    ReportFaults way(1);
    way.orders.delay_us = 2500;
    const std::uint32_t start = 0xFFFF'FFFF - 1000;
    way.send(numbered(1), start);
    way.send(numbered(2), start + 1000);
    Report report;
    QVERIFY(!way.arrived(start + 2499, report));
    QVERIFY(way.arrived(start + 2500, report));
    QCOMPARE(report[0], std::uint8_t{1});
    QVERIFY(!way.arrived(start + 2500, report));
    QVERIFY(way.arrived(start + 3500, report));
    QCOMPARE(report[0], std::uint8_t{2});
  }

  void as_many_are_lost_and_corrupted_as_ordered() {
    ReportFaults way(1);
    way.orders = {.loss = 0.25, .corruption = 0.1};
    int arrived = 0, corrupted = 0;
    Report report;
    for (int i = 0; i < 10'000; ++i) {
      const Report sent = numbered(static_cast<std::uint8_t>(i));
      way.send(sent, 0);
      if (!way.arrived(0, report)) continue;
      ++arrived;
      const int turned = turned_bits(sent, report);
      QVERIFY(turned <= 1);
      corrupted += turned;
    }
    QVERIFY(about(10'000 - arrived, 2500.0));
    QVERIFY(about(corrupted, 0.1 * arrived));
  }

  void stuck_it_sends_the_last_one_again() {
    ReportFaults way(1);
    Report report;
    way.send(numbered(1), 0);
    QVERIFY(way.arrived(0, report));
    way.orders.stuck = true;
    for (std::uint8_t n = 2; n < 5; ++n) {
      way.send(numbered(n), n);
      QVERIFY(way.arrived(n, report));
      QCOMPARE(report[0], std::uint8_t{1});
    }
    way.orders.stuck = false;
    way.send(numbered(9), 9);
    QVERIFY(way.arrived(9, report));
    QCOMPARE(report[0], std::uint8_t{9});
  }

  void more_than_fit_are_lost_and_cleared_ones_never_arrive() {
    ReportFaults way(1);
    way.orders.delay_us = 10;
    for (std::uint8_t n = 0; n < 100; ++n) way.send(numbered(n), 0);
    Report report;
    int arrived = 0;
    while (way.arrived(10, report)) ++arrived;
    QCOMPARE(arrived, 64);
    way.send(numbered(1), 0);
    way.clear();
    QVERIFY(!way.arrived(10, report));
  }
};

QTEST_APPLESS_MAIN(TestReportFaults)
#include "tst_report_faults.moc"
