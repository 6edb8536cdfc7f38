// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_geometry.hpp"

#include <QTest>
#include <cmath>
#include <stdexcept>

#include "components/kinematics/laparoscope_model.hpp"

using namespace trocar;

namespace {

template <typename Check>
QString complaint(Check&& check) {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

}  // namespace

Q_DECLARE_METATYPE(trocar::LaparoscopeGeometry)
Q_DECLARE_METATYPE(trocar::LaparoscopeLimits)

class TestLaparoscopeGeometry : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void defaults_are_valid() {
    validate(LaparoscopeGeometry{});
    validate(LaparoscopeMasses{});
    validate(LaparoscopeLimits{}, LaparoscopeGeometry{});
    QVERIFY(std::abs(LaparoscopeMasses{}.ring - 4.995e-3) < 1e-9);
  }

  void impossible_geometry_is_refused_with_its_cure_data() {
    QTest::addColumn<LaparoscopeGeometry>("geometry");
    QTest::addColumn<QString>("expected");
    QTest::newRow("no tool") << LaparoscopeGeometry{.tool_length = 0.0}
                             << "tool_length = 0: needs a length above 0 m";
    QTest::newRow("ring plane nowhere")
        << LaparoscopeGeometry{.ring_plane = std::nan("")} << "ring_plane = nan: needs a finite";
    QTest::newRow("no rings") << LaparoscopeGeometry{.ring_radius = -1.0}
                              << "ring_radius = -1: needs a radius above 0 m";
    QTest::newRow("negative platform")
        << LaparoscopeGeometry{.platform_radius = -.01} << "platform_radius = -0.01: needs";
    QTest::newRow("base inside the platform")
        << LaparoscopeGeometry{.base_radius = .03}
        << "base_radius = 0.03: must exceed platform_radius = 0.04 m";
    QTest::newRow("links too short")
        << LaparoscopeGeometry{.link_length = .09}
        << "link_length = 0.09: must exceed base_radius - platform_radius = 0.1 m; lengthen";
    QTest::newRow("links not a number")
        << LaparoscopeGeometry{.link_length = std::nan("")} << "link_length = nan";
  }
  void impossible_geometry_is_refused_with_its_cure() {
    QFETCH(LaparoscopeGeometry, geometry);
    QFETCH(QString, expected);
    const QString text = complaint([&] { LaparoscopeModel model(geometry); });
    QVERIFY2(text.contains(expected), qPrintable(text));
  }

  void masses_must_not_be_negative() {
    LaparoscopeMasses masses;
    masses.pin = -0.1;
    QVERIFY(complaint([&] { validate(masses); }).contains("pin = -0.1: needs a value of at least"));
  }

  void limits_must_fit_the_geometry_data() {
    QTest::addColumn<LaparoscopeLimits>("limits");
    QTest::addColumn<QString>("expected");
    QTest::newRow("centre beyond the rings") << LaparoscopeLimits{.centre_offset = .09}
                                             << "centre_offset = 0.09: must lie above 0 and below";
    QTest::newRow("sliders swapped") << LaparoscopeLimits{.slider_low = 0.0}
                                     << "slider_low = 0: must be below slider_high = -0.19 m";
    QTest::newRow("tool pulled out")
        << LaparoscopeLimits{.engagement_high = .16} << "engagement_high = 0.16";
    QTest::newRow("cone of a right angle") << LaparoscopeLimits{.tilt = 1.58} << "tilt = 1.58";
    QTest::newRow("no travel") << LaparoscopeLimits{.ring_travel = 0.0} << "ring_travel = 0";
    QTest::newRow("no engagement")
        << LaparoscopeLimits{.engagement_low = 0.0} << "engagement_low = 0";
    QTest::newRow("link angle") << LaparoscopeLimits{.link_angle = 1.6} << "link_angle = 1.6";
  }
  void limits_must_fit_the_geometry() {
    QFETCH(LaparoscopeLimits, limits);
    QFETCH(QString, expected);
    const QString text = complaint([&] { validate(limits, LaparoscopeGeometry{}); });
    QVERIFY2(text.contains(expected), qPrintable(text));
  }
};

QTEST_APPLESS_MAIN(TestLaparoscopeGeometry)
#include "tst_laparoscope_geometry.moc"
