// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/page_report.hpp"

#include <QTest>
#include <limits>

#include "tests/support/allocation_counter.hpp"

using namespace trocar::hid;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

IdentityPage identity() {
  IdentityPage p;
  p.firmware = 0x0102;
  p.serial = 0xA1B2C3D4;
  p.model = {'D', 'e', 'v', ' ', '1'};
  return p;
}
GeometryPage geometry() {
  return {0.15f, -0.02f, 0.09f, 0.14f, 0.04f, 0.21f, 2};
}
RangePage range() {
  return {{-0.3f, -0.3f, -0.3f, -4, -2, 0}, {-0.2f, -0.2f, -0.2f, 4, 6, 8}};
}
LimitsPage limits() {
  return {{200, 200, 200, 12, 12, 12}, {2, 2, 2, 20, 20, 20}};
}
CalibrationPage calibration() {
  return {{2e-6f, -2e-6f, 2e-6f, 1, 1, 1}, {-5, 0, 5, 1, 2, 3}};
}

template <typename Page>
ReportDefect through(const Page& page, Page& back) {
  Report report;
  encode(page, 77, report);
  PageRequest header;
  if (decode_header(report, header) != ReportDefect::none || header.page != Page::number ||
      header.sequence != 77)
    return ReportDefect::foreign;
  return decode(report, back);
}

template <typename Page>
bool survives(const Page& page) {
  Page back;
  return through(page, back) == ReportDefect::none && back == page;
}

template <typename Page>
bool refused(const Page& good, const Page& bad) {
  Page back = good;
  return through(bad, back) == ReportDefect::malformed && back == good;
}

}  // namespace

class TestPageReport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void what_was_encoded_is_decoded() {
    QVERIFY(survives(identity()));
    QVERIFY(survives(geometry()));
    QVERIFY(survives(range()));
    QVERIFY(survives(limits()));
    QVERIFY(survives(calibration()));
    QCOMPARE(identity().model_name(), std::string_view("Dev 1"));
    IdentityPage full = identity();
    full.model.fill('x');
    QVERIFY(survives(full));
    QCOMPARE(full.model_name().size(), std::size_t(24));
  }

  void a_request_is_told_from_an_answer() {
    Report report;
    PageRequest back;
    encode(PageRequest{PageNumber::limits, 65535}, report);
    QCOMPARE(decode(report, back), ReportDefect::none);
    QVERIFY((back == PageRequest{PageNumber::limits, 65535}));
    QCOMPARE(decode_header(report, back), ReportDefect::foreign);
    report[59] = 1;
    seal(report);
    QCOMPARE(decode(report, back), ReportDefect::malformed);
    encode(PageRequest{static_cast<PageNumber>(5), 1}, report);
    QCOMPARE(decode(report, back), ReportDefect::malformed);
  }

  void another_page_is_foreign() {
    Report report;
    LimitsPage back = limits();
    encode(range(), 1, report);
    QCOMPARE(decode(report, back), ReportDefect::foreign);
    QVERIFY(back == limits());
  }

  void what_no_device_can_mean_is_malformed() {
    const auto with = [](auto page, auto change) {
      change(page);
      return page;
    };
    const auto i = [&](auto change) { return refused(identity(), with(identity(), change)); };
    QVERIFY(i([](auto& p) { p.protocol = 2; }));
    QVERIFY(i([](auto& p) { p.axis_count = 7; }));
    QVERIFY(i([](auto& p) { p.period_us = 0; }));
    QVERIFY(i([](auto& p) { p.watchdog_us = 0; }));
    QVERIFY(i([](auto& p) { p.model[1] = '\x1b'; }));
    QVERIFY(i([](auto& p) { p.model[20] = 'x'; }));  // behind the end
    const auto g = [&](auto change) { return refused(geometry(), with(geometry(), change)); };
    QVERIFY(g([](auto& p) { p.tool_length = 0; }));
    QVERIFY(g([](auto& p) { p.ring_plane = not_a_number; }));
    QVERIFY(g([](auto& p) { p.ring_radius = -1; }));
    QVERIFY(g([](auto& p) { p.base_radius = infinity; }));
    QVERIFY(g([](auto& p) { p.platform_radius = 0.14f; }));
    QVERIFY(g([](auto& p) { p.link_length = not_a_number; }));
    QVERIFY(g([](auto& p) { p.roll = 3; }));
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const auto r = [&](auto change) { return refused(range(), with(range(), change)); };
      QVERIFY(r([&](auto& p) { p.lowest[axis] = p.highest[axis]; }));
      QVERIFY(r([&](auto& p) { p.lowest[axis] = not_a_number; }));
      QVERIFY(r([&](auto& p) { p.highest[axis] = infinity; }));
      const auto l = [&](auto change) { return refused(limits(), with(limits(), change)); };
      QVERIFY(l([&](auto& p) { p.peak[axis] = 0; }));
      QVERIFY(l([&](auto& p) { p.peak[axis] = not_a_number; }));
      QVERIFY(l([&](auto& p) { p.speed[axis] = -1; }));
      const auto c = [&](auto change) {
        return refused(calibration(), with(calibration(), change));
      };
      QVERIFY(c([&](auto& p) { p.unit[axis] = 0; }));
      QVERIFY(c([&](auto& p) { p.unit[axis] = not_a_number; }));
      QVERIFY(c([&](auto& p) { p.unit[axis] = -infinity; }));
    }
  }

  void allocates_nothing() {
    QCOMPARE(trocar::test::allocations_in([] {
               survives(identity());
               survives(calibration());
             }),
             0);
  }
};

QTEST_APPLESS_MAIN(TestPageReport)
#include "tst_page_report.moc"
