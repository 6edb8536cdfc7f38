// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/spsc_queue.hpp"

#include <QTest>
#include <cstdint>
#include <thread>

using trocar::SpscQueue;

namespace {

/// Larger than a word, so that one that is torn shows.
struct Sample {
  std::uint64_t number = 0;
  std::uint64_t parts[7] = {};

  static Sample of(std::uint64_t number) {
    Sample sample{number, {}};
    for (std::uint64_t i = 0; i < 7; ++i) sample.parts[i] = number * 31 + i;
    return sample;
  }
  bool operator==(const Sample&) const = default;
};

}  // namespace

class TestSpscQueue : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void an_empty_queue_gives_nothing() {
    SpscQueue<int, 4> queue;
    QVERIFY(!queue.try_pop());
  }

  void a_full_queue_takes_nothing_and_keeps_what_it_has() {
    SpscQueue<int, 4> queue;
    for (int i = 0; i < 4; ++i) QVERIFY(queue.try_push(i));
    QVERIFY(!queue.try_push(4));
    for (int i = 0; i < 4; ++i) QCOMPARE(queue.try_pop().value_or(-1), i);
    QVERIFY(!queue.try_pop());
  }

  void values_keep_their_order_round_the_end() {
    SpscQueue<int, 4> queue;
    for (int i = 0; i < 100; i += 3) {
      for (int j = 0; j < 3; ++j) QVERIFY(queue.try_push(i + j));
      for (int j = 0; j < 3; ++j) QCOMPARE(queue.try_pop().value_or(-1), i + j);
    }
  }

  void two_threads_at_full_speed_tear_lose_and_reorder_nothing() {
    constexpr std::uint64_t count = 1'000'000;
    SpscQueue<Sample, 64> queue;
    std::thread writer([&] {
      for (std::uint64_t number = 0; number < count; ++number)
        while (!queue.try_push(Sample::of(number))) std::this_thread::yield();
    });
    std::uint64_t wrong = 0;
    for (std::uint64_t number = 0; number < count;) {
      if (const auto sample = queue.try_pop())
        wrong += *sample != Sample::of(number++);
      else
        std::this_thread::yield();
    }
    writer.join();
    QCOMPARE(wrong, std::uint64_t{0});
    QVERIFY(!queue.try_pop());
  }
};

QTEST_APPLESS_MAIN(TestSpscQueue)
#include "tst_spsc_queue.moc"
