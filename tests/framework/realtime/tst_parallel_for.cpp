// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/parallel_for.hpp"

#include <QTest>
#include <algorithm>
#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using trocar::parallel_for;

class TestParallelFor : public QObject {
  Q_OBJECT

  static void numbers_of_threads() {
    QTest::addColumn<unsigned>("threads");
    QTest::newRow("the calling thread alone") << 1u;
    QTest::newRow("two") << 2u;
    QTest::newRow("three") << 3u;
    QTest::newRow("more than there are pieces") << 64u;
    QTest::newRow("one for each processor") << 0u;
  }

 private Q_SLOTS:
  void each_piece_is_done_once_data() { numbers_of_threads(); }
  void each_piece_is_done_once() {
    QFETCH(unsigned, threads);
    std::vector<int> times(50, 0);
    parallel_for(times.size(), {.threads = threads}, [&](std::size_t i) { ++times[i]; });
    QCOMPARE(times, std::vector<int>(50, 1));
  }

  void nothing_to_do_is_nothing_done() {
    parallel_for(0, {}, [](std::size_t) { QFAIL("there is no piece"); });
  }

  void the_calling_thread_works_too() {
    std::atomic<int> here{0};
    const auto caller = std::this_thread::get_id();
    parallel_for(100, {.threads = 1},
                 [&](std::size_t) { here += std::this_thread::get_id() == caller; });
    QCOMPARE(here.load(), 100);
  }

  // Piece 0 waits until piece 1 has begun, which therefore runs beside it.
  void pieces_run_side_by_side() {
    std::atomic<int> begun{0};
    parallel_for(2, {.threads = 2}, [&](std::size_t) {
      ++begun;
      begun.notify_all();
      for (int seen = begun.load(); seen < 2; seen = begun.load()) begun.wait(seen);
    });
    QCOMPARE(begun.load(), 2);
  }

  void progress_grows_to_all_when_nobody_helps() {
    std::vector<std::size_t> told;
    const auto progress = [&](std::size_t done, std::size_t count) {
      QCOMPARE(count, std::size_t{4});
      told.push_back(done);
    };
    parallel_for(4, {.threads = 1, .progress = progress}, [](std::size_t) {});
    QCOMPARE(told, (std::vector<std::size_t>{1, 2, 3, 4}));
  }

  void progress_is_told_on_the_calling_thread() {
    const auto caller = std::this_thread::get_id();
    bool elsewhere = false;
    std::size_t last = 0;
    bool shrank = false;
    const auto progress = [&](std::size_t done, std::size_t) {
      elsewhere |= std::this_thread::get_id() != caller;
      shrank |= done < last;
      last = done;
    };
    parallel_for(200, {.threads = 3, .progress = progress}, [](std::size_t) {});
    QVERIFY(!elsewhere && !shrank);
    QVERIFY(last <= 200);
  }

  void what_a_piece_throws_comes_out_data() { numbers_of_threads(); }
  void what_a_piece_throws_comes_out() {
    QFETCH(unsigned, threads);
    QVERIFY_THROWS_EXCEPTION(std::runtime_error,
                             parallel_for(20, {.threads = threads}, [](std::size_t i) {
                               if (i == 7) throw std::runtime_error("no such thing");
                             }));
  }

  void the_first_that_threw_is_told_and_the_rest_left_out() {
    std::vector<int> times(20, 0);
    try {
      parallel_for(times.size(), {.threads = 1}, [&](std::size_t i) {
        ++times[i];
        if (i >= 5) throw std::runtime_error(std::to_string(i));
      });
      QFAIL("nothing was thrown");
    } catch (const std::runtime_error& error) {
      QCOMPARE(error.what(), "5");
    }
    QCOMPARE(std::accumulate(times.begin(), times.end(), 0), 6);
  }
};

QTEST_APPLESS_MAIN(TestParallelFor)
#include "tst_parallel_for.moc"
