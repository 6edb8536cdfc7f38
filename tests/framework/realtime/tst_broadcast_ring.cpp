// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/broadcast_ring.hpp"

#include <QTest>
#include <cstring>
#include <memory>
#include <thread>

#include "tests/support/allocation_counter.hpp"

using trocar::BroadcastRing;
using Cursor = BroadcastRing::Cursor;
using Start = Cursor::Start;
using Loss = Cursor::Loss;

namespace {

/// A record's bytes follow from its number, so that one that is torn or lost shows.
std::size_t size_of(std::uint64_t number, std::size_t most) {
  return sizeof number + (number * 2654435761u >> 7) % (most - sizeof number + 1);
}
std::byte byte_of(std::uint64_t number, std::size_t at) {
  return static_cast<std::byte>(number * 31 + at * 7 + 1);
}
std::uint32_t tag_of(std::uint64_t number) {
  return static_cast<std::uint32_t>(number * 2246822519u);
}

void fill(std::span<std::byte> record, std::uint64_t number) {
  for (std::size_t i = sizeof number; i < record.size(); ++i) record[i] = byte_of(number, i);
  std::memcpy(record.data(), &number, sizeof number);
}

bool is_whole(const BroadcastRing::Record& record, std::uint64_t number, std::size_t most) {
  std::uint64_t found = 0;
  if (record.bytes.size() != size_of(number, most)) return false;
  if (record.tag != tag_of(number)) return false;
  std::memcpy(&found, record.bytes.data(), sizeof found);
  for (std::size_t i = sizeof found; i < record.bytes.size(); ++i)
    if (record.bytes[i] != byte_of(number, i)) return false;
  return found == number;
}

void write(BroadcastRing& ring, std::uint64_t number, std::size_t most) {
  fill(ring.begin(size_of(number, most)), number);
  ring.commit(tag_of(number));
}

void write_when_read(BroadcastRing& ring, std::uint64_t number, std::size_t most) {
  fill(ring.begin(size_of(number, most)), number);
  ring.commit_when_read(tag_of(number));
}

/// Reads what there is; each record must be whole and follow on the one before or a counted gap.
struct Reading {
  std::uint64_t next = 0;  // number
  std::uint64_t read = 0;
  std::uint64_t missed = 0;
  std::uint64_t gaps = 0;
  std::uint64_t wrong = 0;

  bool take(Cursor& cursor, std::size_t most) {
    const auto record = cursor.next();
    if (!record) return false;
    next += record->missed;
    missed += record->missed;
    gaps += record->missed > 0;
    wrong += !is_whole(*record, next++, most);
    ++read;
    return true;
  }
};

}  // namespace

class TestBroadcastRing : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void an_empty_ring_has_nothing_to_read() {
    BroadcastRing ring(64, 8);
    QVERIFY(!Cursor(ring).next());
    QVERIFY(!Cursor(ring, Start::oldest).next());
  }

  void a_record_is_not_there_until_it_is_handed_over() {
    BroadcastRing ring(256, 16);
    Cursor cursor(ring);
    QCOMPARE(ring.begin(5).size(), std::size_t{5});
    QVERIFY(!cursor.next());
    ring.commit(3);
    const auto record = cursor.next();
    QVERIFY(record.has_value());
    QCOMPARE(record->bytes.size(), std::size_t{5});
    QCOMPARE(record->tag, 3u);
    QCOMPARE(record->missed, std::uint64_t{0});
    QVERIFY(!cursor.next());
  }

  void room_and_copies_are_aligned_to_eight() {
    BroadcastRing ring(1024, 20);
    Cursor cursor(ring);
    const auto aligned = [](const std::byte* data) {
      return reinterpret_cast<std::uintptr_t>(data) % 8 == 0;
    };
    for (std::size_t size = 1; size < 20; ++size) {
      QVERIFY(aligned(ring.begin(size).data()));
      ring.commit(0);
      QVERIFY(aligned(cursor.next()->bytes.data()));
    }
  }

  void every_reader_gets_every_record() {
    BroadcastRing ring(1024, 64);
    Cursor one(ring), two(ring);
    Reading by_one, by_two;
    for (std::uint64_t number = 0; number < 1000; ++number) {
      write(ring, number, 64);
      by_one.take(one, 64);
      if (number % 3 == 2)
        while (by_two.take(two, 64)) {
        }
    }
    while (by_two.take(two, 64)) {
    }
    for (const Reading& reading : {by_one, by_two}) {
      QCOMPARE(reading.read, std::uint64_t{1000});
      QCOMPARE(reading.missed + reading.wrong, std::uint64_t{0});
    }
  }

  void records_of_every_size_keep_their_contents_round_the_end_data() {
    QTest::addColumn<int>("capacity");
    QTest::addColumn<int>("most");
    QTest::addColumn<int>("waiting");  // records in the ring while it turns
    QTest::newRow("one at a time in the smallest ring") << 1 << 24 << 1;
    QTest::newRow("records up to a quarter of the ring") << 544 << 120 << 3;
    QTest::newRow("several that wait") << 1024 << 100 << 6;
    QTest::newRow("a capacity that is no power of two") << 1000 << 100 << 5;
  }
  void records_of_every_size_keep_their_contents_round_the_end() {
    QFETCH(int, capacity);
    QFETCH(int, most);
    QFETCH(int, waiting);
    const auto largest = static_cast<std::size_t>(most);
    BroadcastRing ring(static_cast<std::size_t>(capacity), largest);
    Cursor cursor(ring);
    Reading reading;
    std::uint64_t written = 0;
    while (reading.read < 10'000) {
      while (written < reading.next + static_cast<std::uint64_t>(waiting))
        write(ring, written++, largest);
      QVERIFY(reading.take(cursor, largest));
    }
    QCOMPARE(reading.missed + reading.wrong, std::uint64_t{0});
  }

  void a_full_ring_overwrites_the_oldest_and_the_reader_is_told_how_many() {
    BroadcastRing ring(16 * 24, 8);  // 15 records of 8 bytes, and the number of the next
    QCOMPARE(ring.capacity(), std::size_t{16 * 24});
    Cursor cursor(ring);
    for (std::uint64_t number = 0; number < 15; ++number) write(ring, number, 8);
    QVERIFY(is_whole(*Cursor(ring, Start::oldest).next(), 0, 8));
    for (std::uint64_t number = 15; number < 22; ++number) write(ring, number, 8);
    const auto record = cursor.next();
    QVERIFY(is_whole(*record, 7, 8));
    QCOMPARE(record->missed, std::uint64_t{7});
    for (std::uint64_t number = 8; number < 22; ++number) {
      const auto next = cursor.next();
      QVERIFY(is_whole(*next, number, 8));
      QCOMPARE(next->missed, std::uint64_t{0});
    }
    QVERIFY(!cursor.next());
  }

  void a_large_record_overwrites_many_small_ones() {
    BroadcastRing ring(0, 104);  // four of the largest
    Cursor cursor(ring);
    for (std::uint64_t number = 0; number < 40; ++number) write(ring, number, 8);
    ring.begin(104);
    ring.commit(9);
    std::uint64_t accounted = 0;
    std::uint32_t last = 0;
    while (const auto record = cursor.next()) {
      accounted += 1 + record->missed;
      last = record->tag;
    }
    QCOMPARE(accounted, std::uint64_t{41});
    QCOMPARE(last, 9u);
  }

  void a_cursor_starts_where_it_is_asked_to_data() {
    QTest::addColumn<int>("written");
    QTest::addColumn<bool>("oldest");
    QTest::addColumn<int>("first");
    QTest::newRow("now, in an empty ring") << 0 << false << 0;
    QTest::newRow("now, in one that has turned") << 100 << false << 100;
    QTest::newRow("the oldest, before any was overwritten") << 10 << true << 0;
    QTest::newRow("the oldest that is still there") << 100 << true << 85;
  }
  void a_cursor_starts_where_it_is_asked_to() {
    QFETCH(int, written);
    QFETCH(bool, oldest);
    QFETCH(int, first);
    BroadcastRing ring(16 * 24, 8);
    std::uint64_t number = 0;
    for (; number < static_cast<std::uint64_t>(written); ++number) write(ring, number, 8);
    Cursor cursor(ring, oldest ? Start::oldest : Start::now);
    write(ring, number++, 8);
    const bool lost_one = oldest && written >= 15;  // the write above took it
    const auto record = cursor.next();
    QCOMPARE(record->missed, std::uint64_t{lost_one});
    QVERIFY(is_whole(*record, static_cast<std::uint64_t>(first) + record->missed, 8));
  }

  void what_a_new_cursor_misses_before_its_first_record_is_counted() {
    BroadcastRing ring(16 * 24, 8);
    for (std::uint64_t number = 0; number < 20; ++number) write(ring, number, 8);
    Cursor cursor(ring);
    for (std::uint64_t number = 20; number < 60; ++number) write(ring, number, 8);
    const auto record = cursor.next();
    QCOMPARE(record->missed, std::uint64_t{25});
    QVERIFY(is_whole(*record, 45, 8));
  }

  void a_record_that_never_fits_is_refused_data() {
    QTest::addColumn<int>("size");
    QTest::newRow("of no bytes") << 0;
    QTest::newRow("larger than the largest") << 121;
    QTest::newRow("larger than the ring") << 1'000'000;
  }
  void a_record_that_never_fits_is_refused() {
    QFETCH(int, size);
    BroadcastRing ring(256, 120);
    QVERIFY(ring.begin(static_cast<std::size_t>(size)).empty());
    QCOMPARE(ring.begin(120).size(), std::size_t{120});
  }

  void a_ring_of_no_records_is_refused() {
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, BroadcastRing(256, 0));
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, BroadcastRing(256, std::size_t{1} << 32));
  }

  void waiting_ends_when_every_lossless_reader_has_made_room() {
    BroadcastRing ring(16 * 24, 8);
    Cursor one(ring, Start::now, Loss::never), two(ring, Start::now, Loss::never);
    const Cursor indifferent(ring);
    for (std::uint64_t number = 0; number < 15; ++number) write_when_read(ring, number, 8);
    std::thread writer([&] { write_when_read(ring, 15, 8); });
    one.next();
    two.next();
    writer.join();
    Reading reading{.next = 1};
    while (reading.take(one, 8)) {
    }
    QCOMPARE(reading.read, std::uint64_t{15});
    QCOMPARE(reading.missed + reading.wrong, std::uint64_t{0});
  }

  void waiting_ends_when_the_slow_reader_is_gone_data() {
    QTest::addColumn<bool>("destroyed");
    QTest::newRow("abandoned") << false;
    QTest::newRow("destroyed") << true;
  }
  void waiting_ends_when_the_slow_reader_is_gone() {
    QFETCH(bool, destroyed);
    BroadcastRing ring(16 * 24, 8);
    auto cursor = std::make_unique<Cursor>(ring, Start::now, Loss::never);
    for (std::uint64_t number = 0; number < 15; ++number) write_when_read(ring, number, 8);
    std::thread writer([&] { write_when_read(ring, 15, 8); });
    if (destroyed)
      cursor.reset();
    else
      cursor->abandon();
    writer.join();
    QVERIFY(is_whole(*Cursor(ring, Start::oldest).next(), 1, 8));
  }

  void lossless_cursors_are_as_many_as_there_are_places() {
    BroadcastRing ring(256, 8);
    std::vector<std::unique_ptr<Cursor>> all;
    for (std::size_t i = 0; i < BroadcastRing::most_lossless; ++i)
      all.push_back(std::make_unique<Cursor>(ring, Start::now, Loss::never));
    QVERIFY_THROWS_EXCEPTION(std::length_error, Cursor(ring, Start::now, Loss::never));
    all.pop_back();
    const Cursor again(ring, Start::now, Loss::never);
  }

  void neither_side_allocates() {
    BroadcastRing ring(4096, 64);
    Cursor cursor(ring);
    std::uint64_t read = 0;
    const int allocations = trocar::test::allocations_in([&] {
      for (std::uint64_t number = 0; number < 10'000; ++number) {
        write(ring, number, 64);
        if (number % 200 > 100)
          while (cursor.next()) ++read;
      }
    });
    QCOMPARE(allocations, 0);
    QVERIFY(read > 1000);
  }

  void readers_at_full_speed_get_whole_records_in_order_and_every_gap_is_counted() {
    constexpr std::uint64_t count = 300'000;
    constexpr std::size_t most = 200;
    BroadcastRing ring(8192, most);
    constexpr std::size_t readers = 5;
    Reading readings[readers];
    std::vector<std::unique_ptr<Cursor>> cursors;
    for (std::size_t i = 0; i < readers; ++i) cursors.push_back(std::make_unique<Cursor>(ring));
    std::atomic<bool> done{false};
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < readers; ++i)
      threads.emplace_back([&, i] {
        const bool slow = i >= 2;
        for (bool last = false; !last;) {
          last = done.load();  // before it looks a last time
          while (readings[i].take(*cursors[i], most))
            if (slow && readings[i].read % 64 == 0)
              std::this_thread::sleep_for(std::chrono::microseconds(200 * i));
        }
      });
    for (std::uint64_t number = 0; number < count; ++number) write(ring, number, most);
    done = true;
    for (std::thread& thread : threads) thread.join();
    std::uint64_t gaps = 0;
    for (const Reading& reading : readings) {
      QCOMPARE(reading.wrong, std::uint64_t{0});
      QCOMPARE(reading.read + reading.missed, count);
      QVERIFY(reading.read > 0);
      gaps += reading.gaps;
    }
    QVERIFY(gaps > 0);  // or nothing was tried
  }

  void lossless_readers_at_full_speed_lose_nothing() {
    constexpr std::uint64_t count = 30'000;
    constexpr std::size_t most = 72;
    BroadcastRing ring(16384, most);
    Reading readings[3];
    std::vector<std::unique_ptr<Cursor>> cursors;
    for (int i = 0; i < 3; ++i)
      cursors.push_back(std::make_unique<Cursor>(ring, Start::now, Loss::never));
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < 3; ++i)
      threads.emplace_back([&, i] {
        while (readings[i].read < count)
          if (!readings[i].take(*cursors[i], most)) std::this_thread::yield();
      });
    for (std::uint64_t number = 0; number < count; ++number) write_when_read(ring, number, most);
    for (std::thread& thread : threads) thread.join();
    for (const Reading& reading : readings)
      QCOMPARE(reading.missed + reading.wrong, std::uint64_t{0});
  }

  void cursors_come_and_go_while_the_writer_runs() {
    constexpr std::size_t most = 72;
    BroadcastRing ring(4096, most);
    std::atomic<bool> done{false};
    std::thread writer([&] {
      for (std::uint64_t number = 0; !done.load(); ++number) write(ring, number, most);
    });
    std::uint64_t wrong = 0;
    for (int i = 0; i < 200; ++i) {
      Cursor cursor(ring, i % 2 == 0 ? Start::now : Start::oldest);
      auto record = cursor.next();
      for (; !record; record = cursor.next()) std::this_thread::yield();
      std::uint64_t number = 0;
      std::memcpy(&number, record->bytes.data(), sizeof number);
      wrong += !is_whole(*record, number, most);
    }
    done = true;
    writer.join();
    QCOMPARE(wrong, std::uint64_t{0});
  }
};

QTEST_APPLESS_MAIN(TestBroadcastRing)
#include "tst_broadcast_ring.moc"
