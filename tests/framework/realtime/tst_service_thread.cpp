// SPDX-License-Identifier: Apache-2.0
// ServiceThread, and what its like meet in: Latest, Handover, Exclusive.
#include "framework/realtime/service_thread.hpp"

#include <QTest>
#include <array>
#include <atomic>
#include <memory>

#include "framework/realtime/exclusive.hpp"
#include "framework/realtime/handover.hpp"
#include "framework/realtime/latest.hpp"

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
    std::atomic<std::int64_t> seen{0};
    ServiceThread writer("writer", [&](const StopFlag& stop) {
      Value next{};
      while (!stop.raised()) {
        next.fill(next[0] + 1);
        latest.store(next);
      }
    });
    std::int64_t before = 0;
    for (int i = 0; i < 20'000; ++i) {
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
