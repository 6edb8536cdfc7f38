// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/heartbeat.hpp"

#include <QTest>
#include <atomic>
#include <thread>

using trocar::Heartbeat;

namespace {

constexpr qint64 ms = 1'000'000;  // [ns]

}  // namespace

class TestHeartbeat : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nobody_gives_up_a_loop_that_did_not_begin() {
    Heartbeat heart;
    QVERIFY(!heart.gives_up(1000 * ms, 3 * ms));
    QVERIFY(!heart.ended());
  }

  void a_beat_may_be_as_old_as_the_patience() {
    Heartbeat heart;
    heart.beat(10 * ms);
    QVERIFY(!heart.gives_up(13 * ms, 3 * ms));
    QVERIFY(heart.gives_up(13 * ms + 1, 3 * ms));
  }

  void a_silence_is_told_once_to_both() {
    Heartbeat heart;
    heart.beat(10 * ms);
    QVERIFY(heart.gives_up(14 * ms, 3 * ms));
    QVERIFY(!heart.gives_up(50 * ms, 3 * ms));
    QCOMPARE(heart.beat(60 * ms), 50 * ms);
    QCOMPARE(heart.beat(61 * ms), qint64{0});
    QVERIFY(heart.gives_up(65 * ms, 3 * ms));
    QCOMPARE(heart.beat(66 * ms), 5 * ms);
  }

  void a_loop_that_ended_is_not_silent() {
    Heartbeat heart;
    heart.beat(10 * ms);
    heart.end();
    QVERIFY(heart.ended());
    QVERIFY(!heart.gives_up(1000 * ms, 3 * ms));
  }

  /// Whatever the moments at which both look: the loop hears of silences as long as there are some.
  void no_silence_is_left_untold() {
    constexpr int silences = 20'000;
    Heartbeat heart;
    std::atomic<qint64> now{ms};
    std::atomic<bool> over{false};
    int given_up = 0;
    heart.beat(now);
    std::thread watcher([&] {
      while (!over)
        if (heart.gives_up(now, ms)) ++given_up;
    });
    int told = 0;
    bool sound = true;
    while (told < silences) {
      now += 2 * ms;
      const qint64 silence = heart.beat(now);
      sound = sound && (silence == 0 || silence >= 2 * ms);
      if (silence > 0) ++told;
    }
    over = true;
    watcher.join();
    QVERIFY(sound);
    if (heart.beat(now) > 0) ++told;
    QVERIFY(given_up >= told);
    QCOMPARE(heart.beat(now), qint64{0});
  }
};

QTEST_GUILESS_MAIN(TestHeartbeat)
#include "tst_heartbeat.moc"
