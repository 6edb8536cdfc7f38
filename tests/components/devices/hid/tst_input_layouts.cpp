// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/input_layouts.hpp"

#include <QTest>
#include <utility>
#include <vector>

using namespace trocar::hid;

namespace {

/// Values by name after a series of reports.
struct Reader {
  InputLayout layout;
  std::vector<double> values;
  explicit Reader(InputLayout l) : layout(std::move(l)), values(layout.fields().size(), -99.0) {}
  bool take(const std::vector<std::uint8_t>& bytes) { return layout.decode(bytes, values); }
  double operator[](const char* name) const {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (layout.fields()[i].name == name) return values[i];
    return -77.0;
  }
};

}  // namespace

class TestInputLayouts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // The reports that github.com/AndunHH/spacemouse, SpaceNavigator.md, recorded.
  void a_space_navigators_recorded_reports() {
    Reader mouse(space_navigator());
    QVERIFY(mouse.take({0x01, 0, 0, 0, 0, 0, 0}));
    for (const char* name : {"x", "y", "z"}) QCOMPARE(mouse[name], 0.0);
    QVERIFY(mouse.take({0x02, 0, 0, 0xE2, 0xFF, 0, 0}));  // about its second axis
    QCOMPARE(mouse["rx"], 0.0);
    QCOMPARE(mouse["ry"], -30.0 / 350.0);
    QCOMPARE(mouse["rz"], 0.0);
    QVERIFY(mouse.take({0x03, 0x01, 0x00}));
    QCOMPARE(mouse["left"], 1.0);
    QCOMPARE(mouse["right"], 0.0);
    QVERIFY(mouse.take({0x03, 0x02, 0x00}));
    QCOMPARE(mouse["left"], 0.0);
    QCOMPARE(mouse["right"], 1.0);
    QVERIFY(mouse.take({0x03, 0x03, 0x00}));
    QCOMPARE(mouse["left"], 1.0);
    QVERIFY(!mouse.take({0x17, 0x64, 0x00}));  // a battery's, which it does not have
  }

  // Its descriptor: report 1 has X, Y, Z and report 2 Rx, Ry, Rz, of 16 bits, from -350 to 350.
  void a_space_navigators_ends() {
    Reader mouse(space_navigator());
    QVERIFY(mouse.take({0x01, 0x5E, 0x01, 0xA2, 0xFE, 0x5E, 0x01}));
    QCOMPARE(mouse["x"], 1.0);
    QCOMPARE(mouse["y"], -1.0);
    QCOMPARE(mouse["z"], 1.0);
    QVERIFY(mouse.take({0x02, 0xA2, 0xFE, 0x5E, 0x01, 0xA2, 0xFE}));
    QCOMPARE(mouse["rx"], -1.0);
    QCOMPARE(mouse["ry"], 1.0);
    QCOMPARE(mouse["rz"], -1.0);
    QCOMPARE(mouse["x"], 1.0);
    QVERIFY(!mouse.take({0x01, 0x5E, 0x01, 0xA2, 0xFE, 0x5E}));
  }

  // Its descriptor: report 1 has X, Y, Z, Rx, Ry, Rz of 16 bits.
  void a_wireless_mouse_has_all_axes_in_one_report() {
    Reader mouse(space_mouse_wireless());
    QVERIFY(mouse.take({0x01, 0x5E, 0x01, 0, 0, 0xA2, 0xFE, 0xAF, 0x00, 0x51, 0xFF, 0x5E, 0x01}));
    QCOMPARE(mouse["x"], 1.0);
    QCOMPARE(mouse["y"], 0.0);
    QCOMPARE(mouse["z"], -1.0);
    QCOMPARE(mouse["rx"], 0.5);
    QCOMPARE(mouse["ry"], -0.5);
    QCOMPARE(mouse["rz"], 1.0);
    QVERIFY(mouse.take({0x03, 0x02, 0x00}));
    QCOMPARE(mouse["right"], 1.0);
    QVERIFY(!mouse.take({0x02, 0, 0, 0, 0, 0, 0}));
    QVERIFY(!mouse.take({0x17, 0x64, 0x01}));  // its battery, of no field
  }

  // Bytes by the order of struct dualshock4_input_report_usb: number, x, y, rx, ry, three of
  // buttons, z, rz.
  void a_dualshock_at_rest_and_pressed() {
    Reader pad(dualshock4());
    std::vector<std::uint8_t> report(64);
    report[0] = 1;
    for (std::size_t i = 1; i <= 4; ++i) report[i] = 128;
    report[5] = 8;
    QVERIFY(pad.take(report));
    for (const InputField& field : pad.layout.fields())
      QCOMPARE(pad[field.name.c_str()], field.name == "hat" ? 8.0 : 0.0);

    report[1] = 0, report[2] = 255, report[3] = 192, report[4] = 64;
    report[8] = 255, report[9] = 51;
    report[7] = 0xFC;  // a counter, of no field
    QVERIFY(pad.take(report));
    QCOMPARE(pad["left_x"], -1.0);
    QCOMPARE(pad["left_y"], 127.0 / 128.0);
    QCOMPARE(pad["right_x"], 0.5);
    QCOMPARE(pad["right_y"], -0.5);
    QCOMPARE(pad["l2_pull"], 1.0);
    QCOMPARE(pad["r2_pull"], 0.2);
    QCOMPARE(pad["ps"], 0.0);
    QCOMPARE(pad["touchpad"], 0.0);
  }

  void each_of_its_buttons_is_one_bit_data() {
    QTest::addColumn<int>("byte");
    QTest::addColumn<int>("mask");
    QTest::newRow("square") << 5 << 0x10;
    QTest::newRow("cross") << 5 << 0x20;
    QTest::newRow("circle") << 5 << 0x40;
    QTest::newRow("triangle") << 5 << 0x80;
    QTest::newRow("l1") << 6 << 0x01;
    QTest::newRow("r1") << 6 << 0x02;
    QTest::newRow("l2") << 6 << 0x04;
    QTest::newRow("r2") << 6 << 0x08;
    QTest::newRow("share") << 6 << 0x10;
    QTest::newRow("options") << 6 << 0x20;
    QTest::newRow("l3") << 6 << 0x40;
    QTest::newRow("r3") << 6 << 0x80;
    QTest::newRow("ps") << 7 << 0x01;
    QTest::newRow("touchpad") << 7 << 0x02;
  }
  void each_of_its_buttons_is_one_bit() {
    QFETCH(int, byte);
    QFETCH(int, mask);
    Reader pad(dualshock4());
    std::vector<std::uint8_t> report(64);
    report[0] = 1;
    report[static_cast<std::size_t>(byte)] = static_cast<std::uint8_t>(mask);
    QVERIFY(pad.take(report));
    for (const InputField& field : pad.layout.fields())
      if (field.bits == 1)
        QCOMPARE(pad[field.name.c_str()], field.name == QTest::currentDataTag() ? 1.0 : 0.0);
  }
};

QTEST_APPLESS_MAIN(TestInputLayouts)
#include "tst_input_layouts.moc"
