// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/report_check.hpp"

#include <QTest>
#include <vector>

#include "components/devices/hid/page_report.hpp"
#include "tests/support/allocation_counter.hpp"

using namespace trocar::hid;

namespace {

constexpr std::int64_t ms = 1'000'000;
const ReportCheckSettings settings{.speed = {1e6, 1e6, 1e6, 1e6, 1e6, 1e6}, .oldest_ns = 3 * ms};

/// A device that reports each millisecond, and a host clock that runs beside its own.
struct Stream {
  StateReport state;
  std::int64_t host_ns = 77 * ms;

  explicit Stream(std::uint16_t sequence = 0, std::uint32_t time_us = 0) {
    state.sequence = sequence;
    state.time_us = time_us;
    state.state = DeviceState::ready;
    state.homed = all_homed;
  }
  void next(int periods = 1) {
    state.sequence = static_cast<std::uint16_t>(state.sequence + periods);
    state.time_us += static_cast<std::uint32_t>(1000 * periods);
    host_ns += periods * ms;
  }
  Report report() const {
    Report bytes;
    encode(state, bytes);
    return bytes;
  }
};

}  // namespace

class TestReportCheck : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_good_stream_is_all_state_across_every_wrap() {
    Stream device(65'000, 0xFFFFFFFF - 300'000);
    ReportCheck check(settings);
    for (int i = 0; i < 70'000; ++i, device.next()) {
      device.state.encoder[0] = i * 10;
      QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::state);
      QVERIFY(check.state() == device.state);
      QCOMPARE(check.age_ns(device.host_ns + 5), 5);
    }
    QCOMPARE(check.lost(), std::uint64_t(0));
    QCOMPARE(check.device_time_us(), std::int64_t(0xFFFFFFFF - 300'000) + 69'999'000);
    QCOMPARE(check.count(ReportVerdict::state), std::uint64_t(70'000));
  }

  void what_is_wrong_is_counted_and_changes_nothing() {
    Stream device;
    ReportCheck check(settings);
    check.take(device.report(), device.host_ns);
    device.next();
    const Report older = device.report();
    device.next();
    const Report taken = device.report();
    QCOMPARE(check.take(taken, device.host_ns), ReportVerdict::state);
    QCOMPARE(check.lost(), std::uint64_t(1));
    const StateReport before = check.state();

    Report bytes = taken;
    QCOMPARE(check.take(taken, device.host_ns), ReportVerdict::repeated);
    QCOMPARE(check.take(older, device.host_ns), ReportVerdict::reordered);
    QCOMPARE(check.take(ReportBytes(taken).first(63), device.host_ns), ReportVerdict::too_short);
    QCOMPARE(check.take({}, device.host_ns), ReportVerdict::too_short);
    QCOMPARE(check.take(std::vector<std::uint8_t>(65), device.host_ns), ReportVerdict::too_long);
    device.next();
    bytes = device.report();
    bytes[9] ^= 4;
    QCOMPARE(check.take(bytes, device.host_ns), ReportVerdict::corrupted);
    bytes = device.report();
    bytes[0] = 0x12;
    seal(bytes);
    QCOMPARE(check.take(bytes, device.host_ns), ReportVerdict::foreign);
    bytes = device.report();
    bytes[59] = 99;
    seal(bytes);
    QCOMPARE(check.take(bytes, device.host_ns), ReportVerdict::malformed);
    encode(LimitsPage{}, 1, bytes);
    QCOMPARE(check.take(bytes, device.host_ns), ReportVerdict::page);

    QVERIFY(check.state() == before);
    QCOMPARE(check.age_ns(device.host_ns), ms);
    QCOMPARE(check.count(ReportVerdict::too_short), std::uint64_t(2));
    for (const auto verdict :
         {ReportVerdict::repeated, ReportVerdict::reordered, ReportVerdict::too_long,
          ReportVerdict::corrupted, ReportVerdict::foreign, ReportVerdict::malformed,
          ReportVerdict::page})
      QCOMPARE(check.count(verdict), std::uint64_t(1));
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::state);
    QCOMPARE(check.lost(), std::uint64_t(1));
  }

  void a_clock_that_stands_still_is_stale() {
    Stream device;
    ReportCheck check(settings);
    check.take(device.report(), device.host_ns);
    for (int i = 1; i < 5; ++i) {
      device.next();
      device.state.time_us = 0;
      QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::stale);
    }
    device.state.time_us = 4000u - 5000u;  // backwards
    ++device.state.sequence;
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::stale);
    device.state.time_us = 5000;
    ++device.state.sequence;
    QCOMPARE(check.take(device.report(), device.host_ns + ms), ReportVerdict::state);
    QCOMPARE(check.count(ReportVerdict::stale), std::uint64_t(5));
  }

  void a_clock_that_leaps_is_stale_and_leaves_the_rest_alone() {
    Stream device;
    ReportCheck check(settings);
    check.take(device.report(), device.host_ns);
    device.next();
    device.state.time_us += 30'000'000;
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::stale);
    device.state.time_us -= 30'000'000;
    device.next();
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::state);
  }

  void a_report_that_was_long_under_way_is_stale() {
    Stream device;
    ReportCheck check(settings);
    check.take(device.report(), device.host_ns);
    device.next();
    QCOMPARE(check.take(device.report(), device.host_ns + 3 * ms), ReportVerdict::state);
    QVERIFY(check.age_ns(device.host_ns + 3 * ms) > 3 * ms - 1000);
    for (int i = 0; i < 20'000; ++i) {
      device.next();
      // The fastest way must not creep up however long all are late.
      QCOMPARE(check.take(device.report(), device.host_ns + 10 * ms), ReportVerdict::stale);
    }
    device.next();
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::state);
  }

  void a_first_report_that_waited_does_not_hide_the_age_of_others() {
    Stream device;
    ReportCheck check(settings);
    check.take(device.report(), device.host_ns + 60 * ms);
    device.next();
    check.take(device.report(), device.host_ns);
    device.next();
    QCOMPARE(check.take(device.report(), device.host_ns + 4 * ms), ReportVerdict::stale);
  }

  void two_crystals_may_differ_data() {
    QTest::addColumn<double>("rate");
    QTest::newRow("device slow") << 1.0001;
    QTest::newRow("device fast") << 0.9999;
  }
  void two_crystals_may_differ() {
    QFETCH(double, rate);
    Stream device;
    ReportCheck check(settings);
    for (int i = 0; i < 200'000; ++i, device.next()) {
      const auto arrival = static_cast<std::int64_t>(i * 1e6 * rate);
      if (check.take(device.report(), arrival) != ReportVerdict::state)
        QFAIL(qPrintable(QString::number(i)));
      QVERIFY(check.age_ns(arrival) < ms / 10);
    }
  }

  void a_jump_is_no_state_until_homed_anew() {
    Stream device;
    ReportCheck check(settings);
    check.take(device.report(), device.host_ns);
    device.next();
    device.state.encoder[4] = 2001;  // as far as motion goes
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::state);
    device.next();
    device.state.encoder[4] += 2002;
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::encoder_jump);
    device.next();
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::unhomed_by_jump);
    check.reset();  // opening it again does not help
    device.next();
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::unhomed_by_jump);
    device.next();
    device.state.homed = 0;
    device.state.state = DeviceState::homing;
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::state);
    device.next();
    device.state.encoder[4] = -700'000;  // set anew
    device.state.homed = all_homed;
    device.state.state = DeviceState::ready;
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::state);
    QCOMPARE(check.count(ReportVerdict::encoder_jump), std::uint64_t(1));
    QCOMPARE(check.count(ReportVerdict::unhomed_by_jump), std::uint64_t(2));
  }

  void lost_reports_are_counted_and_explain_motion() {
    Stream device(65'534);
    ReportCheck check(settings);
    check.take(device.report(), device.host_ns);
    device.next(5);
    device.state.encoder[0] = 10'000;
    QCOMPARE(check.take(device.report(), device.host_ns), ReportVerdict::state);
    QCOMPARE(check.lost(), std::uint64_t(4));
  }

  void a_device_that_starts_anew_needs_a_new_session() {
    Stream device(40'000, 900'000'000);
    ReportCheck check(settings);
    check.take(device.report(), device.host_ns);
    Stream again(0, 0);
    QVERIFY(check.take(again.report(), device.host_ns + ms) != ReportVerdict::state);
    check.reset();
    QVERIFY(!check.any());
    QCOMPARE(check.take(again.report(), device.host_ns + 2 * ms), ReportVerdict::state);
  }

  void allocates_nothing() {
    Stream device;
    ReportCheck check(settings);
    QCOMPARE(trocar::test::allocations_in([&] {
               for (int i = 0; i < 10; ++i, device.next())
                 check.take(device.report(), device.host_ns);
             }),
             0);
  }
};

QTEST_APPLESS_MAIN(TestReportCheck)
#include "tst_report_check.moc"
