// SPDX-License-Identifier: Apache-2.0
// ServiceThread, and what its like meet in: Latest, Handover, Exclusive, Doorbell.
#include "framework/realtime/service_thread.hpp"

#include <QTest>
#include <array>
#include <atomic>
#include <limits>
#include <memory>

#include "framework/realtime/doorbell.hpp"
#include "framework/realtime/exclusive.hpp"
#include "framework/realtime/handover.hpp"
#include "framework/realtime/latest.hpp"
#include "framework/time_source.hpp"

using namespace trocar;

class TestServiceThread : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_serves_until_it_is_to_end() {
    std::atomic<long> turns{0};
    std::atomic<bool> ended{false};
    {
      ServiceThread thread("service", [&](const StopFlag& stop) {
        while (!stop.raised()) ++turns;
        ended = true;
      });
      while (turns < 1000) {
      }
      QVERIFY(!ended);
    }
    QVERIFY(ended);
  }

  void the_latest_value_is_whole() {
    using Value = std::array<std::int64_t, 20>;
    Latest<Value> latest;
    Value value{};
    QVERIFY(!latest.load(value));
    ServiceThread writer("writer", [&](const StopFlag& stop) {
      Value next{};
      while (!stop.raised()) {
        next.fill(next[0] + 1);
        latest.store(next);
      }
    });
    std::int64_t before = 0;
    for (int i = 0; i < 20'000 || before < 1000; ++i) {
      if (!latest.load(value)) continue;
      for (const std::int64_t number : value) QCOMPARE(number, value[0]);
      QVERIFY(value[0] >= before);
      before = value[0];
    }
  }

  void a_thing_goes_over_once() {
    Handover<std::unique_ptr<int>> handover;
    QVERIFY(!handover.take());
    handover.put(std::make_unique<int>(1));
    handover.put(std::make_unique<int>(2));
    const auto thing = handover.take();
    QVERIFY(thing && **thing == 2);
    QVERIFY(!handover.take());
  }

  void a_doorbell_is_heard_and_no_ring_is_lost() {
    Doorbell there, back;
    constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
    std::atomic<bool> over{false};
    ServiceThread echo("echo", [&](const StopFlag&) {
      for (std::uint32_t heard = 0; !over; back.ring()) heard = there.wait(heard, never);
    });
    std::uint32_t heard = 0;
    for (int i = 0; i < 2000; ++i) {
      there.ring();
      heard = back.wait(heard, never);
    }
    QVERIFY(heard > 0);
    over = true;  // before the last ring, after which it would wait for good
    there.ring();
  }

  void a_doorbell_is_waited_for_until_a_date() {
    Doorbell bell;
    const std::int64_t begin = monotonic_ns();
    QCOMPARE(bell.wait(0, begin + 2'000'000), 0u);
    QVERIFY(monotonic_ns() - begin >= 2'000'000);
    QVERIFY2(bell.wait(0, 1) == 0u, "a date that is over");
    bell.ring();
    QCOMPARE(bell.wait(0, 1), 1u);
  }

  void one_at_a_time() {
    Exclusive exclusive;
    long count = 0;  // no atomic
    const auto work = [&](const StopFlag&) {
      for (int i = 0; i < 10'000; ++i) exclusive.run([&] { ++count; });
    };
    { ServiceThread a("a", work), b("b", work); }
    QCOMPARE(count, 20'000L);
    QCOMPARE(exclusive.run([&] { return count; }), 20'000L);
  }
};

QTEST_APPLESS_MAIN(TestServiceThread)
#include "tst_service_thread.moc"
