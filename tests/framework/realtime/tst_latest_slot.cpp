// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/latest_slot.hpp"

#include <QTest>
#include <array>
#include <atomic>
#include <thread>
#include <vector>

using trocar::LatestSlot;

namespace {

/// A value of nine words that all follow from its number.
struct Value {
  std::array<std::uint64_t, 9> words{};

  static Value of(std::uint64_t n) {
    Value value;
    for (std::size_t i = 0; i < value.words.size(); ++i)
      value.words[i] = n * 0x9e3779b97f4a7c15u + i;
    return value;
  }
  bool whole() const {
    for (std::size_t i = 1; i < words.size(); ++i)
      if (words[i] != words[0] + i) return false;
    return true;
  }
  std::uint64_t number() const { return words[0] * 0xf1de83e19937733du; }  // the inverse, mod 2^64
};

std::span<const std::byte> bytes_of(const Value& value) {
  return std::as_bytes(std::span(value.words));
}
std::span<std::byte> room_in(Value& value) {
  return std::as_writable_bytes(std::span(value.words));
}

constexpr std::int64_t ever = std::numeric_limits<std::int64_t>::max();

}  // namespace

class TestLatestSlot : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_newest_that_is_old_enough() {
    LatestSlot slot(sizeof(Value));
    Value read;
    QVERIFY(!slot.load(ever, room_in(read)));
    slot.store(10, bytes_of(Value::of(1)));
    QVERIFY(slot.load(ever, room_in(read)) && read.number() == 1);
    QVERIFY(!slot.load(10, room_in(read)));  // strictly older
    QVERIFY(slot.load(11, room_in(read)) && read.number() == 1);
    slot.store(20, bytes_of(Value::of(2)));
    QVERIFY(slot.load(20, room_in(read)) && read.number() == 1);
    QVERIFY(slot.load(21, room_in(read)) && read.number() == 2);
    slot.store(30, bytes_of(Value::of(3)));
    QVERIFY(slot.load(30, room_in(read)) && read.number() == 2);
    QVERIFY(!slot.load(20, room_in(read)));  // two values back is as far as it goes
  }

  void sizes_that_are_no_whole_words() {
    for (std::size_t size = 1; size < 20; ++size) {
      LatestSlot slot(size);
      std::vector<std::byte> in(size), out(size + 1, std::byte{77});
      for (std::size_t i = 0; i < size; ++i) in[i] = static_cast<std::byte>(i + 1);
      slot.store(0, in);
      QVERIFY(slot.load(ever, std::span(out).first(size)));
      QVERIFY(std::equal(in.begin(), in.end(), out.begin()));
      QCOMPARE(out.back(), std::byte{77});
    }
  }

  // TROCAR_SLOT_READS=1000000000 makes it read that often.
  void nothing_torn_and_nothing_out_of_order_data() {
    QTest::addColumn<int>("readers");
    QTest::newRow("one reader") << 1;
    QTest::newRow("three readers") << 3;
  }
  void nothing_torn_and_nothing_out_of_order() {
    QFETCH(int, readers);
    const auto wanted =
        static_cast<std::uint64_t>(std::max(1, qEnvironmentVariableIntValue("TROCAR_SLOT_READS")));
    constexpr std::uint64_t least_stores = 300'000;
    LatestSlot slot(sizeof(Value));
    std::atomic<bool> done{false};
    std::atomic<int> wrong{0};
    std::atomic<std::uint64_t> reads{0}, stores{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < readers; ++i)
      threads.emplace_back([&] {
        std::uint64_t last = 0;
        Value value;
        while (!done.load(std::memory_order_acquire)) {
          if (!slot.load(ever, room_in(value))) continue;
          reads.fetch_add(1, std::memory_order_relaxed);
          if (!value.whole() || value.number() < last) ++wrong;
          last = value.number();
        }
        if (!slot.load(ever, room_in(value)) || value.number() != stores.load()) ++wrong;
      });
    std::uint64_t n = 0;
    while (n < least_stores || reads.load(std::memory_order_relaxed) < wanted) {
      ++n;
      slot.store(static_cast<std::int64_t>(n), bytes_of(Value::of(n)));
    }
    stores = n;
    done.store(true, std::memory_order_release);
    for (std::thread& thread : threads) thread.join();
    QCOMPARE(wrong.load(), 0);
    qInfo("%llu reads of %llu stores", static_cast<unsigned long long>(reads.load()),
          static_cast<unsigned long long>(n));
  }
};

QTEST_APPLESS_MAIN(TestLatestSlot)
#include "tst_latest_slot.moc"
