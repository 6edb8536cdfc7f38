// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/loop_thread.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>
#include <atomic>
#include <stdexcept>
#include <thread>

using trocar::run_on_loop_thread;
using trocar::Shortcomings;

namespace {

struct Scheduling {
  int policy = -1;
  int priority = -1;
  int slack = -1;  // [ns]
  bool operator==(const Scheduling&) const = default;

  static Scheduling here() {
    Scheduling now;
    sched_param param{};
    pthread_getschedparam(pthread_self(), &now.policy, &param);
    now.priority = param.sched_priority;
    now.slack = prctl(PR_GET_TIMERSLACK);
    return now;
  }
};

/// What is missing for a process without any privilege, a line each.
QStringList shortcomings_without_privileges(bool& ran) {
  int ends[2];
  if (pipe(ends) != 0) return {"no pipe"};
  const pid_t child = fork();
  if (child == 0) {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_RTPRIO, &none);
    setrlimit(RLIMIT_MEMLOCK, &none);
    if (geteuid() == 0 && setuid(65534) != 0) _exit(2);
    bool called = false;
    std::string text;
    for (const std::string& one : run_on_loop_thread({.realtime = true}, [&] { called = true; }))
      text += one + '\n';
    const ssize_t sent = write(ends[1], text.data(), text.size());
    _exit(called && sent == static_cast<ssize_t>(text.size()) ? 0 : 1);
  }
  close(ends[1]);
  QByteArray text(4096, '\0');
  text.resize(std::max<ssize_t>(0, read(ends[0], text.data(), 4096)));
  close(ends[0]);
  int status = -1;
  waitpid(child, &status, 0);
  ran = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return QString::fromUtf8(text).split('\n', Qt::SkipEmptyParts);
}

}  // namespace

class TestLoopThread : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_runs_on_a_thread_of_its_own_and_asks_for_nothing_in_virtual_time() {
    std::thread::id there;
    Scheduling inside;
    const Shortcomings missing = run_on_loop_thread({.realtime = false}, [&] {
      there = std::this_thread::get_id();
      inside = Scheduling::here();
    });
    QVERIFY(there != std::thread::id());
    QVERIFY(there != std::this_thread::get_id());
    QVERIFY(inside == Scheduling::here());
    QVERIFY(missing.empty());
  }

  void what_the_loop_throws_is_rethrown_data() {
    QTest::addColumn<bool>("realtime");
    QTest::newRow("in virtual time") << false;
    QTest::newRow("in real time") << true;
  }
  void what_the_loop_throws_is_rethrown() {
    QFETCH(bool, realtime);
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, run_on_loop_thread({.realtime = realtime}, [] {
                               throw std::runtime_error("broken");
                             }));
  }

  void the_calling_thread_and_its_helpers_keep_their_scheduling() {
    const Scheduling before = Scheduling::here();
    Scheduling older, newer;
    std::atomic<bool> looping{false}, seen{false};
    std::thread helper([&] {
      while (!looping) std::this_thread::yield();
      older = Scheduling::here();
      seen = true;
    });
    run_on_loop_thread({.realtime = true}, [&] {
      looping = true;
      while (!seen) std::this_thread::sleep_for(std::chrono::microseconds(100));
    });
    helper.join();
    std::thread([&] { newer = Scheduling::here(); }).join();
    QVERIFY(older == before);
    QVERIFY(newer == before);
    QVERIFY(Scheduling::here() == before);
  }

  void in_real_time_it_gets_what_it_says_it_does_not_lack() {
    Scheduling inside;
    const Shortcomings missing = run_on_loop_thread({.realtime = true, .priority = 10},
                                                    [&] { inside = Scheduling::here(); });
    QStringList all;
    for (const std::string& one : missing) all += QString::fromStdString(one);
    const bool lacks_priority = !all.filter("no real-time priority").isEmpty();
    QCOMPARE(inside.policy == SCHED_FIFO && inside.priority == 10, !lacks_priority);
    if (all.filter("timer slack").isEmpty() && lacks_priority) QCOMPARE(inside.slack, 1);
  }

  void without_privileges_it_runs_and_says_what_is_missing_and_the_cure() {
#if defined(__SANITIZE_THREAD__)
    QSKIP("a child process may start no threads there");
#endif
    bool ran = false;
    const QStringList missing = shortcomings_without_privileges(ran);
    QVERIFY(ran);
    [[maybe_unused]] const QStringList memory = missing.filter("memory is not locked");
    const QStringList priority = missing.filter("no real-time priority");
#if !defined(__SANITIZE_ADDRESS__)  // which makes mlockall() do nothing, with success
    QCOMPARE(memory.size(), 1);
    QVERIFY(memory[0].contains("memlock") && memory[0].contains("limits.conf"));
#endif
    QCOMPARE(priority.size(), 1);
    QVERIFY(priority[0].contains("rtprio") && priority[0].contains("limits.conf"));
  }
};

QTEST_APPLESS_MAIN(TestLoopThread)
#include "tst_loop_thread.moc"
