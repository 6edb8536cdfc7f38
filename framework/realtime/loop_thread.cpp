// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/loop_thread.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>

#include <algorithm>
#include <barrier>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <exception>
#include <string>
#include <thread>

#include "framework/realtime/stop_flag.hpp"

namespace trocar {
namespace {

constexpr std::size_t stack_to_touch = 256 * 1024;  // [bytes]

/// A page that is touched for the first time in the loop costs a fault there.
void touch_stack() {
  [[maybe_unused]] volatile unsigned char stack[stack_to_touch];
  for (std::size_t i = 0; i < stack_to_touch; i += 4096) stack[i] = 0;
}

void lock_memory(Shortcomings& missing) {
  if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) return;
  missing.push_back(std::string("memory is not locked (") + std::strerror(errno) +
                    "): raise \"memlock\" to unlimited in /etc/security/limits.conf");
}

void set_scheduling(int priority, Shortcomings& missing) {
  sched_param param{};
  param.sched_priority = priority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &param);
  if (error != 0)
    missing.push_back(std::string("no real-time priority (") + std::strerror(error) +
                      "): raise \"rtprio\" to 90 in /etc/security/limits.conf and log in again");
  if (prctl(PR_SET_TIMERSLACK, 1ul) != 0)
    missing.push_back(std::string("timer slack not set: ") + std::strerror(errno));
}

void keep_to(const LoopThreadOptions& options, Shortcomings& missing) {
  if (!options.processor) return;
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<unsigned>(*options.processor), &set);
  const int error = pthread_setaffinity_np(pthread_self(), sizeof set, &set);
  if (error != 0)
    missing.push_back("thread " + options.name + " is not on processor " +
                      std::to_string(*options.processor) + " (" + std::strerror(error) +
                      "): this machine has 0 to " +
                      std::to_string(std::thread::hardware_concurrency() - 1));
}

void become_realtime(const LoopThreadOptions& options, Shortcomings& missing) {
  lock_memory(missing);
  keep_to(options, missing);
  set_scheduling(options.priority, missing);
  touch_stack();
}

std::int64_t now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

}  // namespace

Shortcomings run_on_loop_threads(const std::vector<LoopThread>& threads) {
  constexpr std::int64_t lead_ns =
      1'000'000;  // for every thread to get from the barrier to its wait
  struct Outcome {
    Shortcomings missing;
    std::exception_ptr error;
  };
  std::vector<Outcome> outcomes(threads.size());
  std::int64_t start_ns = 0;
  StopFlag failed;
  std::barrier ready(static_cast<std::ptrdiff_t>(threads.size()),
                     [&]() noexcept { start_ns = now_ns() + lead_ns; });
  const auto body = [&](std::size_t i) {
    const LoopThread& thread = threads[i];
    Outcome& outcome = outcomes[i];
    try {
      if (thread.options.realtime) become_realtime(thread.options, outcome.missing);
      if (thread.prepare) thread.prepare();
    } catch (...) {
      outcome.error = std::current_exception();
      failed.raise();
    }
    ready.arrive_and_wait();
    if (failed.raised()) return;
    try {
      thread.loop(start_ns);
    } catch (...) {
      outcome.error = std::current_exception();
    }
  };
  std::vector<std::thread> running;
  for (std::size_t i = 0; i < threads.size(); ++i) running.emplace_back(body, i);
  for (std::thread& one : running) one.join();
  if (std::any_of(threads.begin(), threads.end(),
                  [](const LoopThread& thread) { return thread.options.realtime; }))
    munlockall();
  Shortcomings missing;
  for (const Outcome& outcome : outcomes) {
    if (outcome.error) std::rethrow_exception(outcome.error);
    for (const std::string& one : outcome.missing)
      if (std::find(missing.begin(), missing.end(), one) == missing.end()) missing.push_back(one);
  }
  return missing;
}

Shortcomings run_on_loop_thread(const LoopThreadOptions& options,
                                const std::function<void()>& loop) {
  return run_on_loop_threads({{options, {}, [&](std::int64_t) { loop(); }}});
}

}  // namespace trocar
