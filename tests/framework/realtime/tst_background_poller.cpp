// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/background_poller.hpp"

#include <QTest>
#include <atomic>
#include <stdexcept>

using trocar::BackgroundPoller;

class TestBackgroundPoller : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void finish_polls_until_nothing_is_left() {
    std::atomic<int> left{0};
    BackgroundPoller poller([&] { return left.load() > 0 && left.fetch_sub(1) > 0; });
    left = 1000;
    poller.finish();
    QCOMPARE(left.load(), 0);
    QVERIFY(!poller.failed());
  }

  void the_destructor_drains_too() {
    std::atomic<int> left{1000};
    {
      const BackgroundPoller poller([&] { return left.load() > 0 && left.fetch_sub(1) > 0; });
    }
    QCOMPARE(left.load(), 0);
  }

  void what_it_throws_finish_rethrows_once() {
    BackgroundPoller poller([]() -> bool { throw std::runtime_error("disk full"); });
    try {
      poller.finish();
      QFAIL("nothing was thrown");
    } catch (const std::runtime_error& error) {
      QCOMPARE(error.what(), "disk full");
    }
    QVERIFY(poller.failed());
    poller.finish();
  }

  void one_that_threw_polls_no_more() {
    std::atomic<int> calls{0};
    BackgroundPoller poller([&]() -> bool {
      ++calls;
      throw 7;
    });
    QVERIFY_THROWS_EXCEPTION(int, poller.finish());
    QCOMPARE(calls.load(), 1);
  }

  void it_works_on_a_thread_of_its_own() {
    std::atomic<bool> elsewhere{false};
    const auto here = std::this_thread::get_id();
    BackgroundPoller poller([&] {
      elsewhere = std::this_thread::get_id() != here;
      return false;
    });
    poller.finish();
    QVERIFY(elsewhere.load());
  }
};

QTEST_APPLESS_MAIN(TestBackgroundPoller)
#include "tst_background_poller.moc"
