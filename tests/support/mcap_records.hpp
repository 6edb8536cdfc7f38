// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QFile>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace trocar::test {

/// One record as it lies in a file: a second, minimal opinion beside McapReader.
struct RawRecord {
  std::uint8_t op = 0;
  qsizetype offset = 0;
  QByteArray content;

  template <typename Number>
  Number number(qsizetype at) const {
    Number value;
    std::memcpy(&value, content.constData() + at, sizeof value);
    return value;
  }
};

/// The records between the two magics of a whole file; `bytes` from `offset` on.
inline std::vector<RawRecord> raw_records(const QByteArray& bytes, qsizetype offset = 8,
                                          qsizetype tail = 8) {
  std::vector<RawRecord> records;
  while (offset + 9 <= bytes.size() - tail) {
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.constData() + offset + 1, sizeof length);
    records.push_back({static_cast<std::uint8_t>(bytes[offset]), offset,
                       bytes.mid(offset + 9, static_cast<qsizetype>(length))});
    offset += 9 + static_cast<qsizetype>(length);
  }
  return records;
}

inline int count_of(const std::vector<RawRecord>& records, int op) {
  int count = 0;
  for (const RawRecord& record : records) count += record.op == op;
  return count;
}

inline QByteArray read_bytes(const std::string& path) {
  QFile file(QString::fromStdString(path));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline void write_bytes(const std::string& path, const QByteArray& bytes) {
  QFile file(QString::fromStdString(path));
  file.remove();  // some file systems wait for the disk when a file is emptied instead
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
    qFatal("cannot write %s", path.c_str());
}

inline std::span<const std::byte> span_of(const QByteArray& bytes) {
  return {reinterpret_cast<const std::byte*>(bytes.constData()),
          static_cast<std::size_t>(bytes.size())};
}

}  // namespace trocar::test
