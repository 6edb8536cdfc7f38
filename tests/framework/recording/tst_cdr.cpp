// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/cdr.hpp"

#include <QTest>
#include <limits>

#include "tests/support/mcap_records.hpp"

using trocar::CdrReader;
using trocar::CdrWriter;
using trocar::test::span_of;

class TestCdr : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void alignment_counts_from_the_fifth_byte_data() {
    QTest::addColumn<quint64>("offset");
    QTest::addColumn<quint64>("size");
    QTest::addColumn<quint64>("expected");
    QTest::newRow("a double right behind the head") << quint64(4) << quint64(8) << quint64(4);
    QTest::newRow("a double behind one byte") << quint64(5) << quint64(8) << quint64(12);
    QTest::newRow("a double behind four bytes") << quint64(8) << quint64(8) << quint64(12);
    QTest::newRow("a byte anywhere") << quint64(7) << quint64(1) << quint64(7);
    QTest::newRow("a word behind three bytes") << quint64(7) << quint64(4) << quint64(8);
  }
  void alignment_counts_from_the_fifth_byte() {
    QFETCH(quint64, offset);
    QFETCH(quint64, size);
    QFETCH(quint64, expected);
    QCOMPARE(trocar::cdr_align(offset, size), expected);
  }

  void the_bytes_are_those_of_the_format() {
    std::vector<std::byte> bytes;
    CdrWriter writer(bytes);
    writer.boolean(true);
    writer.number(1.0);
    writer.string("ab");
    writer.number(std::int16_t{-2});
    const QByteArray expected = QByteArray::fromHex(
        "00010000"  // little-endian CDR
        "01"
        "00000000000000"    // true, filled up to a multiple of 8
        "000000000000f03f"  // 1.0
        "03000000"
        "616200"
        "00"  // 3 bytes with the closing zero, one to fill
        "feff");
    QVERIFY(std::ranges::equal(bytes, span_of(expected)));
  }

  void what_is_written_is_read() {
    std::vector<std::byte> bytes(100, std::byte{0xFF});
    CdrWriter writer(bytes);
    writer.string("");
    writer.number(std::numeric_limits<std::int64_t>::min());
    writer.boolean(false);
    writer.number(std::numeric_limits<std::uint64_t>::max());
    writer.string("Kraft übergroß");
    writer.number(-0.0);
    CdrReader reader(bytes);
    QVERIFY(reader.string().empty());
    QCOMPARE(reader.number<std::int64_t>(), std::numeric_limits<std::int64_t>::min());
    QVERIFY(!reader.boolean());
    QCOMPARE(reader.number<std::uint64_t>(), std::numeric_limits<std::uint64_t>::max());
    QVERIFY(reader.string() == "Kraft übergroß");
    QVERIFY(std::signbit(reader.number<double>()));
    QCOMPARE(reader.left(), std::size_t(0));
  }

  void a_message_cut_anywhere_is_refused() {
    std::vector<std::byte> bytes;
    CdrWriter writer(bytes);
    writer.boolean(true);
    writer.string("text");
    writer.number(2.5);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      const auto read = [&] {
        CdrReader reader(std::span<const std::byte>(bytes).first(size));
        reader.boolean();
        reader.string();
        reader.number<double>();
      };
      QVERIFY_THROWS_EXCEPTION(std::runtime_error, read());
    }
  }

  void wrong_bytes_are_refused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("big-endian") << QByteArray::fromHex("0000000000000000");
    QTest::newRow("a string of 4 GiB") << QByteArray::fromHex("00010000ffffffff");
    QTest::newRow("a string without its zero") << QByteArray::fromHex("000100000200000061626300");
  }
  void wrong_bytes_are_refused() {
    QFETCH(QByteArray, bytes);
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, CdrReader(span_of(bytes)).string());
  }
};

QTEST_APPLESS_MAIN(TestCdr)
#include "tst_cdr.moc"
