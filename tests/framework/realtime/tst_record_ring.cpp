// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/record_ring.hpp"

#include <QTest>
#include <cstring>
#include <thread>

using trocar::RecordRing;

namespace {

/// A record's bytes follow from its number, so that one that is torn or lost shows.
std::size_t size_of(std::uint64_t number, std::size_t most) {
  return sizeof number + (number * 2654435761u >> 7) % (most - sizeof number + 1);
}
std::byte byte_of(std::uint64_t number, std::size_t at) {
  return static_cast<std::byte>(number * 31 + at * 7 + 1);
}

void fill(std::span<std::byte> record, std::uint64_t number) {
  for (std::size_t i = sizeof number; i < record.size(); ++i) record[i] = byte_of(number, i);
  std::memcpy(record.data(), &number, sizeof number);
}

bool is_whole(const RecordRing::Record& record, std::uint64_t number, std::size_t most) {
  std::uint64_t found = 0;
  if (record.bytes.size() != size_of(number, most)) return false;
  if (record.kind != static_cast<std::uint32_t>(number % 5)) return false;
  std::memcpy(&found, record.bytes.data(), sizeof found);
  for (std::size_t i = sizeof found; i < record.bytes.size(); ++i)
    if (record.bytes[i] != byte_of(number, i)) return false;
  return found == number;
}

bool push(RecordRing& ring, std::uint64_t number, std::size_t most) {
  const std::span<std::byte> room = ring.try_begin(size_of(number, most));
  if (room.empty()) return false;
  fill(room, number);
  ring.commit(static_cast<std::uint32_t>(number % 5));
  return true;
}

}  // namespace

class TestRecordRing : public QObject {
  Q_OBJECT

 private slots:
  void an_empty_ring_has_no_front() { QVERIFY(RecordRing(64).front().bytes.empty()); }

  void a_record_is_not_there_until_it_is_handed_over() {
    RecordRing ring(64);
    QCOMPARE(ring.try_begin(5).size(), std::size_t{5});
    QVERIFY(ring.front().bytes.empty());
    ring.commit(3);
    QCOMPARE(ring.front().bytes.size(), std::size_t{5});
    QCOMPARE(ring.front().kind, 3u);
    ring.pop();
    QVERIFY(ring.front().bytes.empty());
  }

  void room_is_aligned_to_eight() {
    RecordRing ring(256);
    for (std::size_t size = 1; size < 20; ++size) {
      const std::span<std::byte> room = ring.try_begin(size);
      QCOMPARE(reinterpret_cast<std::uintptr_t>(room.data()) % 8, std::uintptr_t{0});
      ring.commit(0);
      ring.pop();
    }
  }

  void records_of_every_size_keep_their_contents_round_the_end_data() {
    QTest::addColumn<int>("capacity");
    QTest::addColumn<int>("most");
    QTest::addColumn<int>("waiting");  // records in the ring while it turns
    QTest::newRow("one at a time in the smallest ring") << 64 << 24 << 1;
    QTest::newRow("records up to half the ring") << 256 << 120 << 1;
    QTest::newRow("several that wait") << 1024 << 100 << 6;
    QTest::newRow("a capacity that is no power of two") << 1000 << 100 << 5;
  }
  void records_of_every_size_keep_their_contents_round_the_end() {
    QFETCH(int, capacity);
    QFETCH(int, most);
    QFETCH(int, waiting);
    const auto largest = static_cast<std::size_t>(most);
    RecordRing ring(static_cast<std::size_t>(capacity));
    std::uint64_t written = 0;
    for (std::uint64_t read = 0; read < 10'000; ++read) {
      while (written < read + static_cast<std::uint64_t>(waiting) && push(ring, written, largest))
        ++written;
      QVERIFY2(written > read, "an empty ring takes a record");
      QVERIFY(is_whole(ring.front(), read, largest));
      ring.pop();
    }
  }

  void a_full_ring_gives_no_room_and_loses_nothing() {
    RecordRing ring(256);
    std::uint64_t written = 0;
    while (push(ring, written, 8)) ++written;
    QCOMPARE(written, std::uint64_t{16});  // of 8 bytes with a head of 8
    QVERIFY(ring.try_begin(1).empty());
    for (std::uint64_t read = 0; read < written; ++read) {
      QVERIFY(is_whole(ring.front(), read, 8));
      ring.pop();
    }
    QVERIFY(push(ring, written, 8));
  }

  void a_record_beyond_half_the_ring_is_refused_wherever_the_ring_stands() {
    for (int turned = 0; turned < 16; ++turned) {
      RecordRing ring(256);
      for (int i = 0; i < turned; ++i) {
        ring.try_begin(8);
        ring.commit(0);
        ring.pop();
      }
      QVERIFY(ring.try_begin(121).empty());
      QVERIFY(ring.begin(121).empty());  // and does not wait for what never comes
      QVERIFY(ring.begin(1'000'000).empty());
      QCOMPARE(ring.begin(120).size(), std::size_t{120});
    }
  }

  void a_record_without_bytes_is_refused() {
    RecordRing ring(64);
    QVERIFY(ring.try_begin(0).empty());
    QVERIFY(ring.begin(0).empty());
  }

  void waiting_ends_when_the_reader_makes_room() {
    RecordRing ring(64);
    while (push(ring, 0, 8)) {
    }
    std::size_t given = 0;
    std::thread writer([&] { given = ring.begin(8).size(); });
    ring.pop();
    writer.join();
    QCOMPARE(given, std::size_t{8});
  }

  void waiting_ends_when_the_reader_is_gone() {
    RecordRing ring(64);
    while (push(ring, 0, 8)) {
    }
    std::size_t given = 1;
    std::thread writer([&] { given = ring.begin(8).size(); });
    ring.abandon();
    writer.join();
    QCOMPARE(given, std::size_t{0});
  }

  void two_threads_at_full_speed_tear_lose_and_reorder_nothing() {
    constexpr std::uint64_t count = 1'000'000;
    constexpr std::size_t most = 72;
    RecordRing ring(4096);
    std::thread writer([&] {
      for (std::uint64_t number = 0; number < count; ++number)
        while (!push(ring, number, most)) std::this_thread::yield();
    });
    std::uint64_t wrong = 0;
    for (std::uint64_t number = 0; number < count;) {
      const RecordRing::Record record = ring.front();
      if (record.bytes.empty()) {
        std::this_thread::yield();
        continue;
      }
      wrong += !is_whole(record, number++, most);
      ring.pop();
    }
    writer.join();
    QCOMPARE(wrong, std::uint64_t{0});
    QVERIFY(ring.front().bytes.empty());
  }
};

QTEST_APPLESS_MAIN(TestRecordRing)
#include "tst_record_ring.moc"
