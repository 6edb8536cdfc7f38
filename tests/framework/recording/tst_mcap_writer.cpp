// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/mcap_writer.hpp"

#include <sys/resource.h>

#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "framework/recording/crc32.hpp"
#include "tests/support/mcap_records.hpp"

using namespace trocar::test;
using trocar::McapWriter;

namespace {

constexpr std::uint64_t ms = 1'000'000;  // [ns]
constexpr int op_chunk = 0x06, op_message_index = 0x07;

/// `count` messages of `size` bytes, `step` apart in log time.
void write_messages(McapWriter& writer, int count, int size, std::uint64_t step) {
  const std::uint16_t schema = writer.schema("trocar/msg/Row", "ros2msg", "float64 x\n");
  const std::uint16_t channel = writer.channel("/rows", schema, "cdr");
  const QByteArray payload(size, 'x');
  for (int i = 0; i < count; ++i)
    writer.message(channel, static_cast<std::uint32_t>(i), static_cast<std::uint64_t>(i) * step,
                   static_cast<std::uint64_t>(i) * step, span_of(payload));
}

template <typename Call>
QString message_of(Call&& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace

class TestMcapWriter : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  std::string path(const char* name) const { return folder_.filePath(name).toStdString(); }

 private Q_SLOTS:
  void chunks_close_by_log_time_and_size_data() {
    QTest::addColumn<int>("messages");
    QTest::addColumn<int>("size");      // [B] of each payload
    QTest::addColumn<quint64>("step");  // [ns]
    QTest::addColumn<int>("chunks");
    QTest::newRow("no message: no chunk") << 0 << 8 << quint64(ms) << 0;
    QTest::newRow("one message") << 1 << 8 << quint64(ms) << 1;
    QTest::newRow("499 ms fit into one") << 500 << 8 << quint64(ms) << 1;
    QTest::newRow("the message at 500 ms opens the second") << 501 << 8 << quint64(ms) << 2;
    QTest::newRow("slow messages get a chunk each") << 3 << 8 << quint64(1000 * ms) << 3;
    QTest::newRow("a message of 1 MiB fills a chunk") << 3 << (1 << 20) << quint64(ms) << 3;
    QTest::newRow("log time that stands still") << 100 << 8 << quint64(0) << 1;
  }
  void chunks_close_by_log_time_and_size() {
    QFETCH(int, messages);
    QFETCH(int, size);
    QFETCH(quint64, step);
    QFETCH(int, chunks);
    McapWriter writer(path("chunks.mcap"));
    write_messages(writer, messages, size, step);
    writer.close();
    const auto records = raw_records(read_bytes(path("chunks.mcap")));
    QCOMPARE(count_of(records, op_chunk), chunks);
    QCOMPARE(count_of(records, op_message_index), chunks);
    QCOMPARE(writer.message_count(), static_cast<quint64>(messages));
    QCOMPARE(writer.message_count(0), static_cast<quint64>(messages));
    QCOMPARE(writer.message_count(1), quint64(0));
  }

  void log_time_that_goes_back_does_not_close_a_chunk() {
    McapWriter writer(path("back.mcap"));
    const std::uint16_t channel = writer.channel("/rows", 0, "cdr");
    for (const std::uint64_t time : {1000 * ms, 10 * ms, 1400 * ms})
      writer.message(channel, 0, time, time, {});
    writer.close();
    const auto records = raw_records(read_bytes(path("back.mcap")));
    QCOMPARE(count_of(records, op_chunk), 1);
    for (const RawRecord& record : records) {
      if (record.op != op_chunk) continue;
      QCOMPARE(record.number<quint64>(0), quint64(10 * ms));
      QCOMPARE(record.number<quint64>(8), quint64(1400 * ms));
    }
  }

  void the_order_of_records_is_that_of_the_format() {
    McapWriter writer(path("order.mcap"));
    write_messages(writer, 1, 8, ms);
    writer.flush();
    writer.attachment("a.lua", "text/x-lua", 5, 0, span_of("return 1"));
    writer.metadata("run", {{"seed", "1"}});
    writer.close();
    std::vector<int> ops;
    for (const RawRecord& record : raw_records(read_bytes(path("order.mcap"))))
      ops.push_back(record.op);
    const std::vector<int> expected = {
        0x01, 0x03, 0x04, 0x06, 0x07, 0x09, 0x0C, 0x0F,  // header to end of data
        0x03, 0x04, 0x0B, 0x08, 0x0A, 0x0D,              // summary
        0x0E, 0x0E, 0x0E, 0x0E, 0x0E, 0x0E, 0x02};       // offsets, footer
    QVERIFY(ops == expected);
  }

  void indexes_lead_to_their_records() {
    McapWriter writer(path("index.mcap"));
    for (const char* topic : {"/a", "/b"}) writer.channel(topic, 0, "cdr");
    for (const auto channel : {std::uint16_t{1}, std::uint16_t{0}, std::uint16_t{1}})
      writer.message(channel, channel, 7 * ms, 0, span_of("payload"));
    writer.close();
    const QByteArray bytes = read_bytes(path("index.mcap"));
    const auto head_at = [&](quint64 offset) {  // operation code, length, channel
      return raw_records(bytes, static_cast<qsizetype>(offset)).front();
    };
    int found = 0;
    for (const RawRecord& record : raw_records(bytes)) {
      if (record.op != 0x08) continue;
      QCOMPARE(head_at(record.number<quint64>(16)).op, quint8(op_chunk));
      QCOMPARE(record.number<quint32>(32), 20u);
      for (const qsizetype entry : {36, 46}) {
        const RawRecord index = head_at(record.number<quint64>(entry + 2));
        QCOMPARE(index.op, quint8(op_message_index));
        QCOMPARE(index.number<quint16>(0), record.number<quint16>(entry));
        QCOMPARE(index.number<quint32>(2), index.number<quint16>(0) == 1 ? 32u : 16u);
        ++found;
      }
    }
    QCOMPARE(found, 2);
  }

  void checksums_cover_what_the_format_says() {
    McapWriter writer(path("crc.mcap"));
    write_messages(writer, 3, 8, ms);
    writer.close();
    const QByteArray bytes = read_bytes(path("crc.mcap"));
    const auto crc = [&](qsizetype from, qsizetype to) {
      return trocar::crc32(span_of(bytes.mid(from, to - from)));
    };
    for (const RawRecord& record : raw_records(bytes)) {
      const qsizetype content = record.offset + 9;
      if (record.op == op_chunk)
        QCOMPARE(record.number<quint32>(24), crc(content + 40, content + record.content.size()));
      if (record.op == 0x0F) QCOMPARE(record.number<quint32>(0), crc(0, record.offset));
      if (record.op == 0x02)
        QCOMPARE(record.number<quint32>(16),
                 crc(static_cast<qsizetype>(record.number<quint64>(0)), content + 16));
    }
  }

  void the_checksum_is_the_one_of_zlib() {
    QCOMPARE(trocar::crc32(span_of("123456789")), 0xCBF43926u);  // check value of CRC-32
    QCOMPARE(trocar::crc32(span_of("6789"), trocar::crc32(span_of("12345"))), 0xCBF43926u);
  }

  void two_writes_give_the_same_bytes_and_name_no_path() {
    for (const char* name : {"first.mcap", "second.mcap"}) {
      McapWriter writer(path(name));
      write_messages(writer, 2000, 100, ms);
      writer.attachment("a.lua", "text/x-lua", 5, 0, span_of("return 1"));
    }
    const QByteArray bytes = read_bytes(path("first.mcap"));
    QVERIFY(!bytes.isEmpty());
    QVERIFY(bytes == read_bytes(path("second.mcap")));
    QVERIFY(!bytes.contains(folder_.path().toUtf8()));
    QVERIFY(!bytes.contains("first"));
    QVERIFY(bytes.contains("ros2"));
    QVERIFY(bytes.contains("trocar 0."));
  }

  void overhead_stays_below_a_tenth_at_1_kHz() {
    McapWriter writer(path("overhead.mcap"));
    write_messages(writer, 10'000, 1200, ms);
    writer.close();
    const qsizetype size = read_bytes(path("overhead.mcap")).size();
    QCOMPARE(writer.bytes_written(), static_cast<quint64>(size));
    QCOMPARE(writer.payload_bytes(), quint64(12'000'000));
    const double ratio = static_cast<double>(size) / 12e6;
    qInfo("size / payload = %.4f", ratio);
    QVERIFY(ratio <= 1.1);
  }

  void wrong_use_is_refused_data() {
    QTest::addColumn<int>("use");
    QTest::addColumn<QString>("text");
    QTest::newRow("an unknown channel") << 0 << "message on channel 7";
    QTest::newRow("an unknown schema") << 1 << "names schema 9";
    QTest::newRow("a schema without a name") << 2 << "needs a name";
    QTest::newRow("after close") << 3 << "closed already";
  }
  void wrong_use_is_refused() {
    QFETCH(int, use);
    QFETCH(QString, text);
    McapWriter writer(path("use.mcap"));
    const QString said = message_of([&] {
      if (use == 0) writer.message(7, 0, 0, 0, {});
      if (use == 1) writer.channel("/x", 9, "cdr");
      if (use == 2) writer.schema("", "ros2msg", "");
      if (use == 3) {
        const std::uint16_t channel = writer.channel("/x", 0, "cdr");
        writer.close();
        writer.close();
        writer.message(channel, 0, 0, 0, {});
      }
    });
    QVERIFY2(said.contains(text), qPrintable(said));
  }

  void a_file_that_cannot_be_created_says_why_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("text");
    QTest::newRow("no such folder") << folder_.filePath("none/a.mcap") << "create the folder first";
    QTest::newRow("it is a folder") << folder_.path() << "name of a file";
  }
  void a_file_that_cannot_be_created_says_why() {
    QFETCH(QString, path);
    QFETCH(QString, text);
    const QString said = message_of([&] { McapWriter writer(path.toStdString()); });
    QVERIFY2(said.contains(path) && said.contains(text), qPrintable(said));
  }

  void a_full_disk_is_named() {
    const QString said = message_of([] { McapWriter writer("/dev/full"); });
    QVERIFY2(said.contains("/dev/full") && said.contains("free space"), qPrintable(said));
  }

  void after_a_failed_write_the_whole_chunks_stay() {
    McapWriter writer(path("limit.mcap"));
    write_messages(writer, 1000, 100, ms);  // one chunk written, one open
    const quint64 limit = 90'000;
    rlimit before{};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{limit, before.rlim_max};
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const QString first = message_of([&] { writer.flush(); });
    const QString again = message_of([&] { writer.message(0, 0, 0, 0, {}); });
    const QString closing = message_of([&] { writer.close(); });
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    QVERIFY2(first.contains("limit.mcap") && first.contains("ulimit"), qPrintable(first));
    QCOMPARE(again, first);
    QCOMPARE(closing, first);
    const QByteArray bytes = read_bytes(path("limit.mcap"));
    const auto records = raw_records(bytes, 8, 0);
    QCOMPARE(count_of(records, op_chunk), 1);
    QCOMPARE(records.back().offset + 9 + records.back().content.size(), bytes.size());
  }

  void ten_thousand_messages_cost() {
    QBENCHMARK_ONCE {
      McapWriter writer(path("cost.mcap"));
      write_messages(writer, 10'000, 1200, ms);
    }
  }
};

QTEST_APPLESS_MAIN(TestMcapWriter)
#include "tst_mcap_writer.moc"
