// SPDX-License-Identifier: Apache-2.0
// docs/device-protocol.md against the code: each table covers its 64 bytes, its example is what its
// bytes say at the offsets and types of the table, and the code decodes them so and encodes them
// back.
#include <QFile>
#include <QTest>
#include <bit>
#include <cmath>
#include <map>

#include "components/devices/hid/command_report.hpp"
#include "components/devices/hid/page_report.hpp"
#include "components/devices/hid/state_report.hpp"

using namespace trocar::hid;

namespace {

struct Row {
  int offset = 0, size = 0, count = 1;
  QString type, field, example;
};

struct Section {
  std::vector<Row> rows;
  Report bytes{};
  std::size_t byte_count = 0;
};

using Values = std::vector<double>;
using Fields = std::map<QString, Values>;

/// The section under the heading that starts with `title`, up to the end of its block of bytes.
Section section(const QString& title) {
  QFile file(QStringLiteral(TROCAR_SOURCE_DIR "/docs/device-protocol.md"));
  Section result;
  if (!file.open(QIODevice::ReadOnly)) return result;
  const QString text = QString::fromUtf8(file.readAll());
  const qsizetype from = text.indexOf(QStringLiteral("\n### ") + title);
  const qsizetype to = text.indexOf(QStringLiteral("\n```\n"), from);
  if (from < 0 || to < 0) return result;
  bool bytes = false;
  for (const QString& line : text.mid(from, to - from).split(QLatin1Char('\n'))) {
    if (bytes)
      for (const QString& byte : line.split(QLatin1Char(' '), Qt::SkipEmptyParts))
        result.bytes.at(result.byte_count++) = static_cast<std::uint8_t>(byte.toUInt(nullptr, 16));
    bytes = bytes || line == QStringLiteral("```hex");
    const QStringList cell = line.split(QLatin1Char('|'));
    if (cell.size() != 9 || !cell[1].trimmed().at(0).isDigit()) continue;
    const QStringList type = cell[3].trimmed().split(QStringLiteral(" × "));
    result.rows.push_back({cell[1].trimmed().toInt(), cell[2].trimmed().toInt(),
                           type.size() == 2 ? type[1].toInt() : 1, type[0], cell[4].trimmed(),
                           cell[7].trimmed()});
  }
  return result;
}

/// What the bytes say, read here and by the table's words alone.
Values read(const Section& s, const Row& row) {
  const int size = row.size / row.count;
  Values values;
  for (int k = 0; k < row.count; ++k) {
    std::uint64_t number = 0;
    for (int i = 0; i < size; ++i)
      number += std::uint64_t{s.bytes.at(static_cast<std::size_t>(row.offset + k * size + i))}
                << (8 * i);
    if (row.type == QStringLiteral("f32"))
      values.push_back(
          static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(number))));
    else if (row.type.startsWith(QLatin1Char('i')) && (number >> (8 * size - 1) & 1) != 0)
      values.push_back(static_cast<double>(number) - static_cast<double>(1ULL << (8 * size)));
    else
      values.push_back(static_cast<double>(number));
  }
  return values;
}

Values example(const Row& row) {
  Values values;
  if (row.type == QStringLiteral("char")) {
    for (const QChar c : row.example) values.push_back(c.unicode());
    values.resize(static_cast<std::size_t>(row.count));
  } else if (row.example == QStringLiteral("zeros")) {
    values.resize(static_cast<std::size_t>(row.count));
  } else {
    for (const QString& number : row.example.split(QStringLiteral(", ")))
      values.push_back(number.toDouble());
  }
  return values;
}

template <typename Array>
Values list(const Array& array) {
  Values values;
  for (const auto each : array) values.push_back(static_cast<double>(each));
  return values;
}
template <typename Number>
Values one(Number number) {
  return {static_cast<double>(number)};
}

int size_of(const QString& type) {
  static const std::map<QString, int> sizes{{"u8", 1},  {"u16", 2}, {"i16", 2}, {"i24", 3},
                                            {"u32", 4}, {"i32", 4}, {"f32", 4}, {"char", 1}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

/// Everything about a table but what the code says.
bool table_is_whole(const Section& s) {
  int next = 0;
  for (const Row& row : s.rows) {
    if (row.offset != next || row.size != size_of(row.type) * row.count) return false;
    next += row.size;
    const Values said = read(s, row), meant = example(row);
    if (said.size() != meant.size()) return false;
    for (std::size_t i = 0; i < said.size(); ++i)
      if (!(std::abs(said[i] - meant[i]) <= 1e-7 * std::abs(meant[i]))) {
        qWarning("%s: %g is not %g", qPrintable(row.field), said[i], meant[i]);
        return false;
      }
  }
  return next == 64 && s.byte_count == 64;
}

/// The code's values for every field of the table but those that all reports have.
bool code_agrees(const Section& s, Fields code) {
  for (const Row& row : s.rows) {
    if (row.field == QStringLiteral("kind") || row.field == QStringLiteral("crc") ||
        row.field == QStringLiteral("reserved"))
      continue;
    const auto found = code.find(row.field);
    if (found == code.end() || found->second != read(s, row)) {
      qWarning("the code disagrees about %s", qPrintable(row.field));
      return false;
    }
    code.erase(found);
  }
  return code.empty();
}

template <typename Page, typename Describe>
bool page_agrees(const QString& title, Describe describe) {
  const Section s = section(title);
  PageRequest header;
  Page page;
  if (!table_is_whole(s) || decode_header(s.bytes, header) != ReportDefect::none ||
      decode(s.bytes, page) != ReportDefect::none)
    return false;
  Fields fields = describe(page);
  fields["page"] = one(header.page);
  fields["sequence"] = one(header.sequence);
  Report again;
  encode(page, header.sequence, again);
  return code_agrees(s, fields) && again == s.bytes;
}

}  // namespace

class TestDeviceProtocolDocument : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void state() {
    const Section s = section("State");
    QVERIFY(table_is_whole(s));
    StateReport r;
    QCOMPARE(decode(s.bytes, r), ReportDefect::none);
    QVERIFY(code_agrees(s, {{"flags", one(unsigned(r.state) | (r.dead_man ? 8u : 0u))},
                            {"sequence", one(r.sequence)},
                            {"time", one(r.time_us)},
                            {"encoder", list(r.encoder)},
                            {"current", list(r.current)},
                            {"effort", list(r.effort)},
                            {"temperature", list(r.temperature)},
                            {"last_command", one(r.last_command)},
                            {"homed", one(r.homed)},
                            {"fault", one(r.fault)}}));
    Report again;
    encode(r, again);
    QVERIFY(again == s.bytes);
  }

  void command() {
    const Section s = section("Command");
    QVERIFY(table_is_whole(s));
    CommandReport r;
    QCOMPARE(decode(s.bytes, r), ReportDefect::none);
    QVERIFY(code_agrees(s, {{"flags", one(unsigned(r.mode) | (r.acknowledge ? 128u : 0u))},
                            {"sequence", one(r.sequence)},
                            {"tick", one(r.tick)},
                            {"deadline", one(r.deadline_us)},
                            {"hold", list(r.hold)},
                            {"effort", list(r.effort)}}));
    Report again;
    encode(r, again);
    QVERIFY(again == s.bytes);
  }

  void page_request() {
    const Section s = section("Page request");
    QVERIFY(table_is_whole(s));
    PageRequest r;
    QCOMPARE(decode(s.bytes, r), ReportDefect::none);
    QVERIFY(code_agrees(s, {{"page", one(r.page)}, {"sequence", one(r.sequence)}}));
    Report again;
    encode(r, again);
    QVERIFY(again == s.bytes);
  }

  void pages() {
    QVERIFY(page_agrees<IdentityPage>("Page 0", [](const IdentityPage& p) {
      return Fields{{"protocol", one(p.protocol)}, {"axis_count", one(p.axis_count)},
                    {"firmware", one(p.firmware)}, {"serial", one(p.serial)},
                    {"period", one(p.period_us)},  {"watchdog", one(p.watchdog_us)},
                    {"model", list(p.model)}};
    }));
    QVERIFY(page_agrees<GeometryPage>("Page 1", [](const GeometryPage& p) {
      return Fields{{"tool_length", one(p.tool_length)},
                    {"ring_plane", one(p.ring_plane)},
                    {"ring_radius", one(p.ring_radius)},
                    {"base_radius", one(p.base_radius)},
                    {"platform_radius", one(p.platform_radius)},
                    {"link_length", one(p.link_length)},
                    {"roll", one(p.roll)}};
    }));
    QVERIFY(page_agrees<RangePage>("Page 2", [](const RangePage& p) {
      return Fields{{"lowest", list(p.lowest)}, {"highest", list(p.highest)}};
    }));
    QVERIFY(page_agrees<LimitsPage>("Page 3", [](const LimitsPage& p) {
      return Fields{{"peak", list(p.peak)}, {"speed", list(p.speed)}};
    }));
    QVERIFY(page_agrees<CalibrationPage>("Page 4", [](const CalibrationPage& p) {
      return Fields{{"unit", list(p.unit)}, {"offset", list(p.offset)}};
    }));
  }
};

QTEST_APPLESS_MAIN(TestDeviceProtocolDocument)
#include "tst_device_protocol_document.moc"
