// SPDX-License-Identifier: Apache-2.0
// The layouts of scripts/layouts, on report bytes of the devices' published formats.
#include "components/devices/hid/shipped_layouts.hpp"

#include <QDir>
#include <QTest>
#include <cmath>
#include <random>

#include "tests/support/input_device.hpp"

using namespace trocar;
using namespace trocar::hid;
using namespace trocar::test;

namespace {

/// Values by name after a series of reports.
struct Played {
  DeviceLayout layout;
  std::vector<double> values = std::vector<double>(most_numbers, -99.0);
  explicit Played(const char* name)
      : layout(read_layout_text(shipped_layout(name)).layout.value()) {}
  bool take(const std::vector<std::uint8_t>& bytes) { return layout.fields.decode(bytes, values); }
  double operator[](const std::string& name) const {
    for (std::size_t i = 0; i < layout.fields.fields().size(); ++i)
      if (layout.fields.fields()[i].name == name) return values[i];
    return -77.0;
  }
  const LayoutOutput& output(const std::string& name) const {
    for (const LayoutOutput& each : layout.outputs)
      if (each.name == name) return each;
    throw std::invalid_argument(name);
  }
};

}  // namespace

class TestShippedLayouts : public QObject {
  Q_OBJECT

  static void rows() {
    QTest::addColumn<QString>("name");
    for (const auto& shipped : shipped_layouts())
      QTest::newRow(shipped.name.c_str()) << QString::fromStdString(shipped.name);
  }

 private Q_SLOTS:
  void each_file_is_shipped() {
    QStringList shipped;
    for (const auto& each : shipped_layouts()) {
      shipped << QString::fromStdString(each.name) + ".lua";
      QFile file(TROCAR_SOURCE_DIR "/scripts/layouts/" + shipped.back());
      QVERIFY(file.open(QFile::ReadOnly));
      QCOMPARE(QByteArray::fromStdString(each.text), file.readAll());
    }
    QCOMPARE(shipped, QDir(TROCAR_SOURCE_DIR "/scripts/layouts").entryList({"*.lua"}));
  }

  // The reports that github.com/AndunHH/spacemouse, SpaceNavigator.md, recorded.
  void a_space_navigators_recorded_reports() {
    Played mouse("space_navigator");
    QVERIFY(mouse.take({0x01, 0, 0, 0, 0, 0, 0}));
    for (const char* axis : {"x", "y", "z"})
      QCOMPARE(mouse[std::string("translation.") + axis], 0.0);
    QVERIFY(mouse.take({0x02, 0, 0, 0xE2, 0xFF, 0, 0}));  // about its second axis
    QCOMPARE(mouse["rotation.x"], 0.0);
    QCOMPARE(mouse["rotation.y"], -30.0 / 350.0);
    QCOMPARE(mouse["rotation.z"], 0.0);
    QVERIFY(mouse.take({0x03, 0x01, 0x00}));
    QCOMPARE(mouse["left"], 1.0);
    QCOMPARE(mouse["right"], 0.0);
    QVERIFY(mouse.take({0x03, 0x02, 0x00}));
    QCOMPARE(mouse["left"], 0.0);
    QCOMPARE(mouse["right"], 1.0);
    QVERIFY(mouse.take({0x03, 0x03, 0x00}));
    QCOMPARE(mouse["left"], 1.0);
    QVERIFY(!mouse.take({0x17, 0x64, 0x00}));  // a battery's, which it does not have
    QCOMPARE(mouse.layout.device.text(), std::string("046d:c626"));
  }

  // Its descriptor: report 1 has X, Y, Z and report 2 Rx, Ry, Rz, of 16 bits, from -350 to 350.
  void a_space_navigators_ends() {
    Played mouse("space_navigator");
    QVERIFY(mouse.take({0x01, 0x5E, 0x01, 0xA2, 0xFE, 0x5E, 0x01}));
    QCOMPARE(mouse["translation.x"], 1.0);
    QCOMPARE(mouse["translation.y"], -1.0);
    QCOMPARE(mouse["translation.z"], 1.0);
    QVERIFY(mouse.take({0x02, 0xA2, 0xFE, 0x5E, 0x01, 0xA2, 0xFE}));
    QCOMPARE(mouse["rotation.x"], -1.0);
    QCOMPARE(mouse["rotation.y"], 1.0);
    QCOMPARE(mouse["rotation.z"], -1.0);
    QCOMPARE(mouse["translation.x"], 1.0);
    QVERIFY(!mouse.take({0x01, 0x5E, 0x01, 0xA2, 0xFE, 0x5E}));
  }

  void a_space_mouse_sends_its_buttons_on_a_change_alone() {
    for (const char* name : {"space_navigator", "space_mouse_wireless"}) {
      const Played mouse(name);
      QVERIFY(mouse.output("left").held == Held::attached);
      QVERIFY(mouse.output("translation").held == Held::never);
      QVERIFY(mouse.output("rotation").kind == LayoutOutput::Kind::vector);
      QVERIFY(mouse.output("right").kind == LayoutOutput::Kind::flag);
    }
  }

  // Its descriptor: report 1 has X, Y, Z, Rx, Ry, Rz of 16 bits.
  void a_wireless_mouse_has_all_axes_in_one_report() {
    Played mouse("space_mouse_wireless");
    QVERIFY(mouse.take({0x01, 0x5E, 0x01, 0, 0, 0xA2, 0xFE, 0xAF, 0x00, 0x51, 0xFF, 0x5E, 0x01}));
    QCOMPARE(mouse["translation.x"], 1.0);
    QCOMPARE(mouse["translation.y"], 0.0);
    QCOMPARE(mouse["translation.z"], -1.0);
    QCOMPARE(mouse["rotation.x"], 0.5);
    QCOMPARE(mouse["rotation.y"], -0.5);
    QCOMPARE(mouse["rotation.z"], 1.0);
    QVERIFY(mouse.take({0x03, 0x02, 0x00}));
    QCOMPARE(mouse["right"], 1.0);
    QVERIFY(!mouse.take({0x02, 0, 0, 0, 0, 0, 0}));
    QVERIFY(!mouse.take({0x17, 0x64, 0x01}));  // its battery, of no field
    QCOMPARE(mouse.layout.device.text(), std::string("256f:c62e"));
  }

  // Bytes by the order of struct dualshock4_input_report_usb: number, x, y, rx, ry, three of
  // buttons, z, rz.
  void a_dualshock_at_rest_and_pressed() {
    Played pad("dualshock4");
    std::vector<std::uint8_t> report(64);
    report[0] = 1;
    for (std::size_t i = 1; i <= 4; ++i) report[i] = 128;
    report[5] = 8;
    QVERIFY(pad.take(report));
    for (const LayoutOutput& output : pad.layout.outputs)
      QCOMPARE(pad[output.name], output.rest[0]);
    QCOMPARE(pad["hat"], 8.0);
    QCOMPARE(pad["left_x"], 0.0);

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
    Played pad("dualshock4");
    std::vector<std::uint8_t> report(64);
    report[0] = 1;
    report[static_cast<std::size_t>(byte)] = static_cast<std::uint8_t>(mask);
    QVERIFY(pad.take(report));
    int flags = 0;
    for (const LayoutOutput& output : pad.layout.outputs)
      if (output.kind == LayoutOutput::Kind::flag) {
        ++flags;
        QCOMPARE(pad[output.name], output.name == QTest::currentDataTag() ? 1.0 : 0.0);
      }
    QCOMPARE(flags, 14);
  }

  void any_bytes_are_taken_whole_or_not_at_all_data() { rows(); }
  void any_bytes_are_taken_whole_or_not_at_all() {
    QFETCH(QString, name);
    Played device(name.toLatin1());
    const auto& fields = device.layout.fields.fields();
    std::mt19937 random(7);
    int taken = 0;
    for (int i = 0; i < 20'000; ++i) {
      std::vector<std::uint8_t> report(random() % 70);
      for (std::uint8_t& byte : report) byte = static_cast<std::uint8_t>(random());
      if (!report.empty() && i % 2 == 0) report[0] = static_cast<std::uint8_t>(random() % 4);
      const std::vector<double> before = device.values;
      if (!device.take(report)) {
        QCOMPARE(device.values, before);
        continue;
      }
      ++taken;
      for (std::size_t k = 0; k < fields.size(); ++k) {
        if (!device.layout.fields.holds(report, k)) {
          QCOMPARE(device.values[k], before[k]);
          continue;
        }
        const double raw = device.values[k] / fields[k].scale + fields[k].centre;
        const double span = std::exp2(fields[k].bits);
        QVERIFY(raw >= (fields[k].is_signed ? -span / 2 : 0.0) - 1e-6);
        QVERIFY(raw <= (fields[k].is_signed ? span / 2 : span) - 1.0 + 1e-6);
      }
    }
    QVERIFY(taken > 100);
  }
};

QTEST_APPLESS_MAIN(TestShippedLayouts)
#include "tst_shipped_layouts.moc"
