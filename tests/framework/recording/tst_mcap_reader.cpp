// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/mcap_reader.hpp"

#include <QTemporaryDir>
#include <QTest>

#include "framework/recording/mcap_writer.hpp"
#include "tests/support/mcap_records.hpp"

using namespace trocar::test;
using trocar::McapError;
using trocar::McapReader;
using trocar::McapWriter;

namespace {

constexpr std::uint64_t ms = 1'000'000;  // [ns]

/// Three chunks on two channels, two attachments, one metadata record.
void write_small_log(const std::string& path) {
  McapWriter writer(path);
  const std::uint16_t row = writer.schema("trocar/msg/Row", "ros2msg", "float64 x\n");
  const std::uint16_t event = writer.schema("trocar/msg/Event", "ros2msg", "string text\n");
  const std::uint16_t rows = writer.channel("/rows", row, "cdr", {{"rate_hz", "1000"}});
  writer.attachment("wall.lua", "text/x-lua", 1, 2, span_of("trocar.Wall {}"));
  const std::uint16_t events = writer.channel("/events", event, "cdr");
  writer.metadata("run", {{"seed", "7"}, {"clock", "simulated"}});
  for (std::uint32_t i = 0; i < 6; ++i)
    writer.message(i == 3 ? events : rows, i, (10 + 250 * i) * ms, 250 * i * ms,
                   span_of(QByteArray::number(i).repeated(3)));
  writer.attachment("empty.txt", "text/plain", 3, 0, {});
}

struct Contents {
  bool complete = false;
  int messages = 0;
};

/// Everything that a file gives; throws as the reader does.
Contents read_all(const std::string& path) {
  const McapReader reader(path);
  Contents contents;
  reader.messages([&](const trocar::McapMessage&) { ++contents.messages; });
  for (const auto& attachment : reader.attachments()) reader.read(attachment);
  contents.complete = reader.complete();
  if (contents.complete)
    reader.verify();
  else if (reader.problem().empty())
    qFatal("incomplete without a reason");
  if (reader.message_count() != static_cast<std::uint64_t>(contents.messages))
    qFatal("counted %d of %d", static_cast<int>(reader.message_count()), contents.messages);
  return contents;
}

QByteArray record_of(quint8 op, quint64 length, const QByteArray& content) {
  QByteArray bytes(1, static_cast<char>(op));
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  return bytes + content;
}

}  // namespace

class TestMcapReader : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  QByteArray log_;
  std::string path(const char* name) const { return folder_.filePath(name).toStdString(); }

 private Q_SLOTS:
  void initTestCase() {
    write_small_log(path("log.mcap"));
    log_ = read_bytes(path("log.mcap"));
    QVERIFY(log_.size() > 1000 && log_.size() < 5000);
  }

  void what_was_written_is_read() {
    const McapReader reader(path("log.mcap"));
    QVERIFY2(reader.complete(), reader.problem().c_str());
    QCOMPARE(reader.profile(), std::string("ros2"));
    QCOMPARE(reader.library(), McapWriter::default_library());
    QCOMPARE(reader.schemas().size(), std::size_t(2));
    QCOMPARE(reader.schemas().at(2).data, std::string("string text\n"));
    QVERIFY(reader.channel("/none") == nullptr);
    const trocar::McapChannel* rows = reader.channel("/rows");
    QVERIFY(rows != nullptr);
    QCOMPARE(rows->metadata.at("rate_hz"), std::string("1000"));
    QCOMPARE(reader.message_count(), quint64(6));
    QCOMPARE(reader.message_count(rows->id), quint64(5));
    QCOMPARE(reader.start_time_ns(), quint64(10 * ms));
    QCOMPARE(reader.end_time_ns(), quint64(1260 * ms));
    QCOMPARE(reader.metadata().at(0).entries.at("clock"), std::string("simulated"));
    reader.verify();
  }

  void messages_come_in_order_with_all_their_parts() {
    const McapReader reader(path("log.mcap"));
    std::uint32_t next = 0;
    reader.messages([&](const trocar::McapMessage& message) {
      QCOMPARE(message.sequence, next);
      QCOMPARE(message.channel, std::uint16_t(next == 3 ? 1 : 0));
      QCOMPARE(message.log_time_ns, (10 + 250 * next) * ms);
      QCOMPARE(message.publish_time_ns, 250 * next * ms);
      const QByteArray text = QByteArray::number(next).repeated(3);
      QVERIFY(std::ranges::equal(message.payload, span_of(text)));
      ++next;
    });
    QCOMPARE(next, 6u);
  }

  void a_range_of_time_selects_data() {
    QTest::addColumn<quint64>("first");  // [ms]
    QTest::addColumn<quint64>("last");   // [ms]
    QTest::addColumn<int>("count");
    QTest::newRow("everything") << quint64(0) << quint64(9999) << 6;
    QTest::newRow("both ends are included") << quint64(260) << quint64(760) << 3;
    QTest::newRow("between two messages") << quint64(261) << quint64(509) << 0;
    QTest::newRow("after the last") << quint64(1261) << quint64(9999) << 0;
  }
  void a_range_of_time_selects() {
    QFETCH(quint64, first);
    QFETCH(quint64, last);
    QFETCH(int, count);
    int seen = 0;
    McapReader(path("log.mcap"))
        .messages([&](const trocar::McapMessage&) { ++seen; }, {first * ms, last * ms});
    QCOMPARE(seen, count);
  }

  void attachments_are_read_by_their_index() {
    const McapReader reader(path("log.mcap"));
    QCOMPARE(reader.attachments().size(), std::size_t(2));
    const trocar::McapAttachment& lua = reader.attachments()[0];
    QCOMPARE(lua.name, std::string("wall.lua"));
    QCOMPARE(lua.media_type, std::string("text/x-lua"));
    QCOMPARE(lua.create_time_ns, quint64(2));
    QVERIFY(std::ranges::equal(reader.read(lua), span_of("trocar.Wall {}")));
    QVERIFY(reader.read(reader.attachments()[1]).empty());
  }

  void an_empty_log_is_complete() {
    McapWriter(path("empty.mcap")).close();
    const McapReader reader(path("empty.mcap"));
    QVERIFY2(reader.complete(), reader.problem().c_str());
    QCOMPARE(reader.message_count(), quint64(0));
    reader.verify();
  }

  void a_file_cut_anywhere_yields_its_whole_chunks() {
    const auto records = raw_records(log_);
    std::vector<std::pair<qsizetype, int>> chunks;  // end [B], messages up to there
    for (const RawRecord& record : records) {
      if (record.op != 0x06) continue;
      const QByteArray inside = record.content.mid(40);
      const int before = chunks.empty() ? 0 : chunks.back().second;
      chunks.emplace_back(record.offset + 9 + record.content.size(),
                          before + count_of(raw_records(inside, 0, 0), 0x05));
    }
    QCOMPARE(chunks.back().second, 6);
    for (qsizetype size = 0; size < log_.size(); ++size) {
      write_bytes(path("cut.mcap"), log_.first(size));
      if (size < 8) {
        QVERIFY_THROWS_EXCEPTION(McapError, McapReader(path("cut.mcap")));
        continue;
      }
      int expected = 0;
      for (const auto& [end, messages] : chunks)
        if (end <= size) expected = messages;
      const Contents contents = read_all(path("cut.mcap"));
      QVERIFY(!contents.complete);
      QCOMPARE(contents.messages, expected);
    }
  }

  void every_flipped_bit_is_found() {
    for (qsizetype at = 0; at < log_.size(); ++at) {
      QByteArray bytes = log_;
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << (at % 8)));
      write_bytes(path("flip.mcap"), bytes);
      bool found = false;
      try {
        found = !read_all(path("flip.mcap")).complete;
      } catch (const McapError& error) {
        found = true;
        QVERIFY(error.offset() <= static_cast<quint64>(bytes.size()));
      }
      QVERIFY2(found, qPrintable(QString("byte %1").arg(at)));
    }
  }

  void a_damaged_chunk_ends_reading_with_its_place() {
    QByteArray bytes = log_;
    const qsizetype at = bytes.indexOf("222");
    bytes[at] = 'x';
    write_bytes(path("chunk.mcap"), bytes);
    const McapReader reader(path("chunk.mcap"));
    int seen = 0;
    try {
      reader.messages([&](const trocar::McapMessage&) { ++seen; });
      QFAIL("the damage went unnoticed");
    } catch (const McapError& error) {
      QVERIFY(QString(error.what()).contains("checksum of the chunk"));
      QVERIFY(error.offset() < static_cast<quint64>(at));
    }
    QCOMPARE(seen, 2);
  }

  void hostile_bytes_end_in_a_clear_error_data() {
    QTest::addColumn<QByteArray>("after_header");
    QTest::addColumn<QString>("text");
    const QByteArray huge = QByteArray::fromHex("ffffffffffffff7f");
    const QByteArray small_chunk = QByteArray(24 + 4, '\0');
    QTest::newRow("a record longer than the file")
        << record_of(0x06, ~quint64(0), {}) << "a record of 18446744073709551615 bytes";
    QTest::newRow("a chunk too short for its head") << record_of(0x06, 3, "abc") << "should follow";
    QTest::newRow("a chunk that claims more than it has")
        << record_of(0x06, 40, QByteArray(16, '\0') + huge + QByteArray(8, '\0') + huge)
        << "bytes should follow";
    QTest::newRow("two sizes that differ")
        << record_of(0x06, 40, QByteArray(16, '\0') + huge + QByteArray(16, '\0'))
        << "two sizes differ";
    QTest::newRow("a compressed chunk")
        << record_of(0x06, 44,
                     small_chunk + QByteArray::fromHex("04000000") + "zstd" + QByteArray(8, '\0'))
        << "compressed with 'zstd'";
    QTest::newRow("a string longer than its record")
        << record_of(0x03, 6, QByteArray::fromHex("0100ffffffff")) << "4294967295 bytes should";
    QTest::newRow("a string longer by one byte")
        << record_of(0x03, 6, QByteArray::fromHex("010001000000")) << "1 bytes should follow, 0";
    QTest::newRow("a schema with id 0") << record_of(0x03, 2, QByteArray(2, '\0')) << "the id 0";
    QTest::newRow("a channel of an unknown schema")
        << record_of(0x04, 16, QByteArray::fromHex("00000500") + QByteArray(12, '\0'))
        << "names schema 5";
    QTest::newRow("a message on an unknown channel")
        << record_of(0x05, 22, QByteArray(22, '\0')) << "message on channel 0";
    QTest::newRow("an attachment larger than its record")
        << record_of(0x09, 36, QByteArray(24, '\0') + huge + QByteArray(4, '\0')) << "claims";
    QTest::newRow("a map whose key stands twice")
        << record_of(0x0C, 24,
                     QByteArray(4, '\0') + QByteArray::fromHex("10000000") + QByteArray(16, '\0'))
        << "stands twice";
    QTest::newRow("a footer in the middle")
        << record_of(0x02, 20, QByteArray(20, '\0')) << "before the file's end";
  }
  void hostile_bytes_end_in_a_clear_error() {
    QFETCH(QByteArray, after_header);
    QFETCH(QString, text);
    const qsizetype header_end = raw_records(log_)[1].offset;
    write_bytes(path("hostile.mcap"), log_.first(header_end) + after_header);
    const McapReader reader(path("hostile.mcap"));
    const QString problem = QString::fromStdString(reader.problem());
    QVERIFY2(problem.contains(text), qPrintable(problem));
    QVERIFY(problem.contains("at byte"));
    reader.messages([](const trocar::McapMessage&) { QFAIL("no message is whole"); });
  }

  void limits_hold_data() {
    QTest::addColumn<quint64>("record");
    QTest::addColumn<quint64>("listing");
    QTest::addColumn<bool>("fits");
    QTest::newRow("both are large enough") << quint64(4096) << quint64(4096) << true;
    QTest::newRow("a chunk is too large") << quint64(80) << quint64(4096) << false;
    QTest::newRow("the listing is too large") << quint64(4096) << quint64(300) << false;
  }
  void limits_hold() {
    QFETCH(quint64, record);
    QFETCH(quint64, listing);
    QFETCH(bool, fits);
    bool read = false;
    try {
      const McapReader reader(path("log.mcap"), {.record = record, .listing = listing});
      reader.messages([](const trocar::McapMessage&) {});
      read = reader.complete();
    } catch (const McapError& error) {
      QVERIFY2(QString(error.what()).contains("limit"), error.what());
    }
    QCOMPARE(read, fits);
  }

  void a_scan_keeps_the_limit_of_the_listing() {
    write_bytes(path("scan.mcap"), log_.first(log_.size() - 1));
    const McapReader reader(path("scan.mcap"), {.record = 4096, .listing = 300});
    QVERIFY2(QString::fromStdString(reader.problem()).contains("take more than the limit of 300"),
             reader.problem().c_str());
  }

  void a_damaged_attachment_is_not_read() {
    QByteArray bytes = log_;
    bytes[bytes.indexOf("trocar.Wall")] = 'x';
    write_bytes(path("attached.mcap"), bytes);
    const McapReader reader(path("attached.mcap"));
    QVERIFY(reader.complete());
    QVERIFY_THROWS_EXCEPTION(McapError, reader.read(reader.attachments()[0]));
  }

  void a_file_without_summary_is_scanned_and_complete() {
    const auto records = raw_records(log_);
    QByteArray bytes = log_.first(8);
    for (const RawRecord& record : records) {
      if (record.op == 0x0F) break;
      bytes += record_of(record.op, static_cast<quint64>(record.content.size()), record.content);
    }
    bytes += record_of(0x0F, 4, QByteArray(4, '\0')) + record_of(0x02, 20, QByteArray(20, '\0')) +
             log_.first(8);
    write_bytes(path("plain.mcap"), bytes);
    const Contents contents = read_all(path("plain.mcap"));
    QVERIFY(contents.complete);
    QCOMPARE(contents.messages, 6);
    QCOMPARE(McapReader(path("plain.mcap")).end_time_ns(), quint64(1260 * ms));
  }

  void a_chunk_damaged_inside_counts_no_message() {
    const qsizetype at = raw_records(log_)[1].offset;
    const QByteArray channel = record_of(0x04, 16, QByteArray(16, '\0'));
    const QByteArray inside = record_of(0x05, 22, QByteArray(22, '\0')) + record_of(0x05, 99, {});
    QByteArray size(8, '\0');
    size[0] = static_cast<char>(inside.size());
    const QByteArray chunk = QByteArray(16, '\0') + size + QByteArray(8, '\0') + size + inside;
    write_bytes(
        path("inside.mcap"),
        log_.first(at) + channel + record_of(0x06, static_cast<quint64>(chunk.size()), chunk));
    const Contents contents = read_all(path("inside.mcap"));
    QVERIFY(!contents.complete);
    QCOMPARE(contents.messages, 0);
  }

  void what_is_no_log_is_refused_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("text");
    QTest::newRow("no such file") << folder_.filePath("none.mcap") << "No such file";
    QTest::newRow("a folder") << folder_.path() << "not a regular file";
    QTest::newRow("a text") << QString(TROCAR_SOURCE_DIR "/CMakeLists.txt") << "not an MCAP file";
  }
  void what_is_no_log_is_refused() {
    QFETCH(QString, path);
    QFETCH(QString, text);
    try {
      McapReader reader(path.toStdString());
      QFAIL("it was read");
    } catch (const std::runtime_error& error) {
      QVERIFY2(QString(error.what()).contains(text), error.what());
      QVERIFY(QString(error.what()).contains(path));
    }
  }
};

QTEST_APPLESS_MAIN(TestMcapReader)
#include "tst_mcap_reader.moc"
