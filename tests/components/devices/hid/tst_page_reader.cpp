// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/page_reader.hpp"

#include <QTest>
#include <stdexcept>

#include "components/devices/laparoscope_device_limits.hpp"
#include "tests/support/emulated_bench.hpp"

using namespace trocar;
using namespace trocar::hid;
using trocar::test::EmulatedBench;

namespace {

constexpr double period = 1e-3;

ExpectedLaparoscope expected() {
  const LaparoscopeDriveSettings drive;
  ExpectedLaparoscope result{.limits = laparoscope_device_limits({}, period),
                             .oldest_report_ns = 5'000'000};
  for (std::size_t i = 0; i < axes; ++i)
    result.resolution[i] = i < 3 ? drive.slider.resolution : drive.ring.resolution;
  return result;
}

LaparoscopePages pages() {
  return laparoscope_pages({}, laparoscope_device_limits({}, period), {});
}

std::string refusal(const LaparoscopePages& told, const ExpectedLaparoscope& wanted) {
  try {
    require_agreement(told, wanted);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace

class TestPageReader : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pages_are_read_between_reports() {
    EmulatedBench bench;
    auto& unit = bench.add(EmulatedBench::settings(5));
    test::BenchSource source(bench, "any");
    const LinkPair pair = source.open();
    const LaparoscopePages told = read_pages(*pair.in, *pair.out, bench);
    QCOMPARE(told.identity.serial, 5u);
    QVERIFY(told.geometry == unit.device.pages().geometry);
    QVERIFY(told.range == unit.device.pages().range);
    QVERIFY(told.limits == unit.device.pages().limits);
    QVERIFY(told.calibration == unit.device.pages().calibration);
  }

  void a_page_that_is_lost_is_asked_for_again() {
    EmulatedBench bench;
    auto& unit = bench.add(EmulatedBench::settings(5));
    unit.faults.orders.loss = 0.5;
    test::BenchSource source(bench, "any");
    const LinkPair pair = source.open();
    const std::int64_t before = bench.now();
    QCOMPARE(read_pages(*pair.in, *pair.out, bench).identity.serial, 5u);
    QVERIFY(bench.now() - before >= 100'000'000);
  }

  void a_device_that_is_silent_is_told() {
    EmulatedBench bench;
    bench.add(EmulatedBench::settings(5)).deaf = true;
    test::BenchSource source(bench, "any");
    const LinkPair pair = source.open();
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, read_pages(*pair.in, *pair.out, bench));
    bench.unplug(bench.units[0]);
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, read_pages(*pair.in, *pair.out, bench));
  }

  void what_agrees_is_taken() { QCOMPARE(refusal(pages(), expected()), std::string()); }

  void a_device_with_more_than_is_needed_is_taken() {
    LaparoscopePages told = pages();
    told.limits.peak.fill(500.0f);
    told.calibration.unit.fill(1e-7f);
    told.range.lowest.fill(-10.0f);
    told.range.highest.fill(20.0f);
    told.identity.watchdog_us = 4000;
    QCOMPARE(refusal(told, expected()), std::string());
  }

  void what_differs_is_named_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* what, const char* said) {
      QTest::newRow(what) << what << said;
    };
    row("tool", "tool_length: the device says 0.16, the script 0.15");
    row("roll", "roll: the device has another gimbal");
    row("peak", "peak effort of axis 2 is 150 and 200 may be sent: set slider_effort");
    row("range", "range of axis 1: the device has -0.3 to -0.19, the script -0.31 to -0.19");
    row("count", "one count of axis 4 is 0.01 and damping was checked for 0.000102265");
    row("watchdog", "its watchdog waits 20000 us: at most 8000 are allowed");
    row("period", "it reports every 3000 us, and a report of 5000 us is stale already");
  }
  void what_differs_is_named() {
    QFETCH(QString, what);
    QFETCH(QString, said);
    LaparoscopePages told = pages();
    if (what == "tool") told.geometry.tool_length = 0.16f;
    if (what == "roll") told.geometry.roll = 2;
    if (what == "peak") told.limits.peak[1] = 150.0f;
    if (what == "range") told.range.lowest[0] = -0.30f;
    if (what == "count") told.calibration.unit[3] = -0.01f;
    if (what == "watchdog") told.identity.watchdog_us = 20'000;
    if (what == "period") told.identity.period_us = 3000;
    const QString message = QString::fromStdString(refusal(told, expected()));
    QVERIFY2(message.contains(said), qPrintable(message));
    QCOMPARE(message.count('\n'), 1);
  }
};

QTEST_APPLESS_MAIN(TestPageReader)
#include "tst_page_reader.moc"
