// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/report_envelope.hpp"

#include <QTest>
#include <cstring>
#include <random>
#include <vector>

#include "framework/recording/crc32.hpp"

using namespace trocar;
using namespace trocar::hid;

class TestReportEnvelope : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_crc_is_the_usual_one() {
    const char* digits = "123456789";
    std::vector<std::uint8_t> bytes(digits, digits + std::strlen(digits));
    QCOMPARE(report_crc(bytes), 0xCBF43926u);
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
      bytes.push_back(static_cast<std::uint8_t>(random()));
      QCOMPARE(report_crc(bytes), crc32(std::as_bytes(std::span(bytes))));
    }
  }

  void fields_are_little_endian_and_keep_their_sign() {
    Report report{};
    ReportWriter out(report);
    out.u8(0xA1);
    out.u16(0xB2C3);
    out.i16(-2);
    out.i24(-8'388'608);
    out.i24(8'388'607);
    out.u32(0x01020304);
    out.i32(-3);
    out.f32(-1.5f);
    const std::vector<std::uint8_t> expected{0xA1, 0xC3, 0xB2, 0xFE, 0xFF, 0x00, 0x00, 0x80,
                                             0xFF, 0xFF, 0x7F, 0x04, 0x03, 0x02, 0x01, 0xFD,
                                             0xFF, 0xFF, 0xFF, 0x00, 0x00, 0xC0, 0xBF};
    QCOMPARE(std::vector<std::uint8_t>(report.begin(), report.begin() + 23), expected);
    ReportReader in(report);
    QCOMPARE(in.u8(), std::uint8_t(0xA1));
    QCOMPARE(in.u16(), std::uint16_t(0xB2C3));
    QCOMPARE(in.i16(), std::int16_t(-2));
    QCOMPARE(in.i24(), -8'388'608);
    QCOMPARE(in.i24(), 8'388'607);
    QCOMPARE(in.u32(), 0x01020304u);
    QCOMPARE(in.i32(), -3);
    QCOMPARE(in.f32(), -1.5f);
    QVERIFY(in.zeros_until(report_size));
  }

  void length_then_crc_then_kind() {
    Report report{};
    report[0] = static_cast<std::uint8_t>(ReportKind::state);
    seal(report);
    QCOMPARE(inspect(report, ReportKind::state), ReportDefect::none);
    QCOMPARE(inspect(report, ReportKind::command), ReportDefect::foreign);
    QCOMPARE(inspect(ReportBytes(report).first(63), ReportKind::state), ReportDefect::too_short);
    QCOMPARE(inspect({}, ReportKind::state), ReportDefect::too_short);
    std::vector<std::uint8_t> longer(report.begin(), report.end());
    longer.push_back(0);
    QCOMPARE(inspect(longer, ReportKind::state), ReportDefect::too_long);
    report[0] = 0x21;  // another version, with a good CRC
    seal(report);
    QCOMPARE(inspect(report, ReportKind::state), ReportDefect::foreign);
  }

  void every_single_bit_and_every_pair_of_bits_counts() {
    Report report{};
    report[0] = static_cast<std::uint8_t>(ReportKind::state);
    seal(report);
    const auto flip = [&](std::size_t bit) {
      report[bit / 8] = static_cast<std::uint8_t>(report[bit / 8] ^ (1u << (bit % 8)));
    };
    for (std::size_t a = 0; a < 8 * report_size; ++a)
      for (std::size_t b = a; b < 8 * report_size; ++b) {
        flip(a);
        if (b != a) flip(b);
        if (inspect(report, ReportKind::state) != ReportDefect::corrupted)
          QFAIL(qPrintable(QStringLiteral("bits %1 and %2").arg(a).arg(b)));
        flip(a);
        if (b != a) flip(b);
      }
  }

  void differences_go_across_the_wrap() {
    QCOMPARE(serial_difference(std::uint16_t(2), std::uint16_t(65535)), std::int16_t(3));
    QCOMPARE(serial_difference(std::uint16_t(65535), std::uint16_t(2)), std::int16_t(-3));
    QCOMPARE(serial_difference(500u, 0xFFFFFF00u), 756);
    QCOMPARE(serial_difference(0xFFFFFF00u, 500u), -756);
  }
};

QTEST_APPLESS_MAIN(TestReportEnvelope)
#include "tst_report_envelope.moc"
