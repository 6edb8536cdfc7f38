// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/loop_thread.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <string>
#include <thread>

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

}  // namespace

Shortcomings run_on_loop_thread(const LoopThreadOptions& options,
                                const std::function<void()>& loop) {
  Shortcomings missing;
  std::exception_ptr error;
  std::thread thread([&] {
    try {
      if (options.realtime) {
        lock_memory(missing);
        set_scheduling(options.priority, missing);
        touch_stack();
      }
      loop();
    } catch (...) {
      error = std::current_exception();
    }
  });
  thread.join();
  if (options.realtime) munlockall();
  if (error) std::rethrow_exception(error);
  return missing;
}

}  // namespace trocar
