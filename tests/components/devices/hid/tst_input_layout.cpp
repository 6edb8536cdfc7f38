// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/input_layout.hpp"

#include <QTest>
#include <limits>

#include "tests/support/allocation_counter.hpp"

using namespace trocar::hid;

class TestInputLayout : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bits_data() {
    QTest::addColumn<int>("bit");
    QTest::addColumn<int>("bits");
    QTest::addColumn<bool>("is_signed");
    QTest::addColumn<double>("value");
    // Bytes 0xA5 0x0F 0x80 0xFF 0xFF
    QTest::newRow("a byte") << 0 << 8 << false << 165.0;
    QTest::newRow("a byte, signed") << 0 << 8 << true << -91.0;
    QTest::newRow("one bit, set") << 0 << 1 << false << 1.0;
    QTest::newRow("one bit, clear") << 1 << 1 << false << 0.0;
    QTest::newRow("one bit, signed") << 0 << 1 << true << -1.0;
    QTest::newRow("across two bytes") << 4 << 8 << false << 250.0;
    QTest::newRow("across three bytes, signed") << 7 << 17 << true << -65'505.0;
    QTest::newRow("16 bits, little-endian") << 0 << 16 << false << 4005.0;
    QTest::newRow("32 bits, unsigned") << 8 << 32 << false << 4294934543.0;
    QTest::newRow("32 bits, signed") << 8 << 32 << true << -32753.0;
    QTest::newRow("32 bits across five bytes") << 7 << 32 << false << 4294901791.0;
  }
  void bits() {
    QFETCH(int, bit);
    QFETCH(int, bits);
    QFETCH(bool, is_signed);
    QFETCH(double, value);
    const std::uint8_t bytes[] = {0xA5, 0x0F, 0x80, 0xFF, 0xFF};
    const InputLayout layout({{.name = "f", .offset = bit, .bits = bits, .is_signed = is_signed}});
    double read = 0;
    QVERIFY(layout.decode(bytes, {&read, 1}));
    QCOMPARE(read, value);
  }

  void centre_and_scale() {
    const InputLayout layout({{.name = "f", .centre = 128, .scale = -0.5}});
    const std::uint8_t bytes[] = {130};
    double read = 0;
    QVERIFY(layout.decode(bytes, {&read, 1}));
    QCOMPARE(read, -1.0);
  }

  void a_report_changes_its_own_fields_alone() {
    const InputLayout layout({{.name = "a", .report = 1, .offset = 8},
                              {.name = "b", .report = 2, .offset = 8},
                              {.name = "c", .report = 2, .offset = 16}});
    double values[] = {-1, -1, -1};
    const std::uint8_t first[] = {1, 10}, second[] = {2, 20, 30}, third[] = {3, 1, 1};
    QVERIFY(layout.decode(first, values));
    QCOMPARE(values[0], 10.0);
    QCOMPARE(values[1], -1.0);
    QVERIFY(layout.decode(second, values));
    QCOMPARE(values[2], 30.0);
    QVERIFY(!layout.decode(third, values));                 // of no field
    QVERIFY(!layout.decode(std::span(second, 2), values));  // too short for c: b stays too
    QVERIFY(!layout.decode({}, values));
    QVERIFY(!layout.decode(first, std::span(values, 2)));  // no room
    QCOMPARE(values[0], 10.0);
    QCOMPARE(values[1], 20.0);
  }

  void what_is_wrong_is_named_data() {
    QTest::addColumn<QString>("says");
    QTest::addColumn<int>("what");
    QTest::newRow("no name") << "no name" << 0;
    QTest::newRow("two of a name") << "two of this name" << 1;
    QTest::newRow("no bits") << "1 to 32" << 2;
    QTest::newRow("too many bits") << "1 to 32" << 3;
    QTest::newRow("in the number") << "the report's number" << 4;
    QTest::newRow("negative bit") << "offset = -1" << 5;
    QTest::newRow("beyond a report") << "offset = 8192" << 6;
    QTest::newRow("report 256") << "1 to 255" << 7;
    QTest::newRow("no scale") << "not zero" << 8;
    QTest::newRow("scale not finite") << "finite" << 9;
    QTest::newRow("numbered or not") << "a device numbers all its reports" << 10;
    QTest::newRow("one behind the other") << "" << 11;
    QTest::newRow("one in the other")
        << "bits 12 to 19 of report 1 overlap with \"f\", 8 to 15" << 12;
  }
  void what_is_wrong_is_named() {
    QFETCH(QString, says);
    QFETCH(int, what);
    InputField f{.name = "f", .report = 1, .offset = 8};
    InputField other{.name = "other", .report = 1, .offset = 16};
    switch (what) {
      case 0:
        f.name.clear();
        break;
      case 1:
        other.name = "f";
        break;
      case 2:
        f.bits = 0;
        break;
      case 3:
        f.bits = 33;
        break;
      case 4:
        f.offset = 7;
        break;
      case 5:
        f.offset = -1;
        break;
      case 6:
        f.offset = 8192;
        break;
      case 7:
        f.report = 256;
        break;
      case 8:
        f.scale = 0;
        break;
      case 9:
        f.scale = std::numeric_limits<double>::infinity();
        break;
      case 10:
        f.report = 0;
        break;
      case 12:
        other.offset = 12;
        break;
    }
    try {
      InputLayout({f, other});
      QVERIFY2(says.isEmpty(), "it was accepted");
    } catch (const std::invalid_argument& error) {
      QVERIFY2(QString::fromStdString(error.what()).contains(says), error.what());
    }
  }

  void allocates_nothing() {
    const InputLayout layout({{.name = "a", .report = 1, .offset = 8}});
    const std::uint8_t bytes[] = {1, 10};
    double value = 0;
    QCOMPARE(trocar::test::allocations_in([&] { layout.decode(bytes, {&value, 1}); }), 0);
  }
};

QTEST_APPLESS_MAIN(TestInputLayout)
#include "tst_input_layout.moc"
