// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/laparoscope_pages.hpp"

#include <QTest>
#include <cmath>

#include "components/devices/hid/axis_scale.hpp"
#include "components/devices/hid/device_state_machine.hpp"
#include "components/devices/hid/state_report.hpp"
#include "components/devices/laparoscope_device_limits.hpp"

using namespace trocar;
using namespace trocar::hid;

namespace {

const LaparoscopeLimits ranges;
const LaparoscopePages pages =
    laparoscope_pages({}, laparoscope_device_limits(ranges, 1e-3), LaparoscopeDriveSettings{});

template <typename Page>
bool good(const Page& page) {
  Report report;
  Page back;
  encode(page, 0, report);
  return decode(report, back) == ReportDefect::none && back == page;
}

}  // namespace

class TestLaparoscopePages : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void they_pass_the_protocol() {
    QVERIFY(good(pages.identity));
    QVERIFY(good(pages.geometry));
    QVERIFY(good(pages.range));
    QVERIFY(good(pages.limits));
    QVERIFY(good(pages.calibration));
    QCOMPARE(pages.identity.model_name(), std::string_view("Trocar laparoscope"));
  }

  void the_geometry_comes_back() {
    const LaparoscopeGeometry geometry = geometry_of(pages.geometry), meant;
    validate(geometry);
    QVERIFY(std::abs(geometry.tool_length - meant.tool_length) < 1e-8);
    QVERIFY(std::abs(geometry.link_length - meant.link_length) < 1e-8);
    QVERIFY(std::abs(geometry.ring_plane - meant.ring_plane) < 1e-8);
    QVERIFY(geometry.roll == meant.roll);
  }

  void the_whole_range_fits_into_24_bits_and_one_count_is_the_encoders() {
    const LaparoscopeDriveSettings drive;
    const AxisScale scale(pages.limits, pages.calibration);
    for (std::size_t i = 0; i < axes; ++i) {
      const int axis = static_cast<int>(i);
      const double unit = i < 3 ? drive.slider.resolution : drive.ring.resolution;
      for (const float end : {pages.range.lowest[i], pages.range.highest[i]}) {
        PerAxis<std::int32_t> counts{};
        counts[i] = static_cast<std::int32_t>(std::lround(static_cast<double>(end) / unit));
        QVERIFY(std::abs(counts[i]) < encoder_max);
        QVERIFY(std::abs(scale.position(counts)[axis] - static_cast<double>(end)) < unit);
      }
      QVERIFY(std::abs(scale.effort({effort_max, effort_max, effort_max, effort_max, effort_max,
                                     effort_max})[axis] -
                       (i < 3 ? drive.slider.peak : drive.ring.peak)) < 1e-5);
    }
  }

  void the_rules_of_a_device_follow_from_them() {
    const DeviceRules rules =
        device_rules(pages.limits, pages.calibration, geometry_of(pages.geometry).ring_radius);
    QCOMPARE(std::round(rules.speed[0]), 1e6);       // 2 m/s in counts of 2 um
    QCOMPARE(std::round(rules.calm_speed[0]), 1e4);  // 20 mm/s
    QCOMPARE(std::round(rules.homing_speed[2]), 1e4);
    QCOMPARE(rules.homing_effort[1], std::int16_t(327));  // 2 N of 200 N, not rounded up
    QCOMPARE(rules.homing_effort[4], std::int16_t(491));  // 0.18 N m of 12 N m
    QVERIFY(std::abs(rules.calm_effort[0] - 163.835) < 1e-3);
    LimitsPage none = pages.limits;
    none.speed[3] = 0;
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, device_rules(none, pages.calibration, 0.09));
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument,
                             device_rules(pages.limits, pages.calibration, 0.0));
  }
};

QTEST_APPLESS_MAIN(TestLaparoscopePages)
#include "tst_laparoscope_pages.moc"
