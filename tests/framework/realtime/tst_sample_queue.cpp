// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/sample_queue.hpp"

#include <QTest>
#include <thread>

using trocar::SampleQueue;

namespace {

constexpr std::int64_t ever = std::numeric_limits<std::int64_t>::max();

std::span<const std::byte> bytes_of(const std::uint64_t& value) {
  return std::as_bytes(std::span(&value, 1));
}
std::span<std::byte> room_in(std::uint64_t& value) {
  return std::as_writable_bytes(std::span(&value, 1));
}

}  // namespace

class TestSampleQueue : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void first_in_first_out_and_full() {
    SampleQueue queue(sizeof(std::uint64_t), 3);
    std::uint64_t read = 0;
    QVERIFY(!queue.try_pop(ever, room_in(read)));
    for (const std::uint64_t n : {1u, 2u, 3u})
      QVERIFY(queue.try_push(static_cast<int>(n), bytes_of(n)));
    QVERIFY(!queue.try_push(4, bytes_of(4)));
    for (const std::uint64_t n : {1u, 2u}) QVERIFY(queue.try_pop(ever, room_in(read)) && read == n);
    QVERIFY(queue.try_push(4, bytes_of(4)));
    for (const std::uint64_t n : {3u, 4u}) QVERIFY(queue.try_pop(ever, room_in(read)) && read == n);
    QVERIFY(!queue.try_pop(ever, room_in(read)));
  }

  void what_is_too_young_waits() {
    SampleQueue queue(sizeof(std::uint64_t), 4);
    std::uint64_t read = 0;
    queue.try_push(10, bytes_of(1));
    queue.try_push(20, bytes_of(2));
    QVERIFY(!queue.try_pop(10, room_in(read)));
    QVERIFY(queue.try_pop(11, room_in(read)) && read == 1);
    QVERIFY(!queue.try_pop(20, room_in(read)));
    QVERIFY(queue.try_pop(21, room_in(read)) && read == 2);
  }

  void each_value_once_and_in_order_between_threads() {
    constexpr std::uint64_t count = 300'000;
    SampleQueue queue(sizeof(std::uint64_t), 64);
    std::uint64_t wrong = 0;
    std::thread reader([&] {
      for (std::uint64_t next = 1; next <= count;) {
        std::uint64_t value = 0;
        if (!queue.try_pop(ever, room_in(value))) {
          std::this_thread::yield();
          continue;
        }
        if (value != next) ++wrong;
        ++next;
      }
    });
    for (std::uint64_t n = 1; n <= count;)
      if (queue.try_push(static_cast<std::int64_t>(n), bytes_of(n)))
        ++n;
      else
        std::this_thread::yield();
    reader.join();
    QCOMPARE(wrong, std::uint64_t{0});
  }
};

QTEST_APPLESS_MAIN(TestSampleQueue)
#include "tst_sample_queue.moc"
