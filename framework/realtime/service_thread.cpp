// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/service_thread.hpp"

#include <pthread.h>
#include <sched.h>

#include <algorithm>

namespace trocar {
namespace {

/// A thread begins as its maker is; only what differs is set. What the machine does not allow is
/// left: the loop's own thread has said so.
void serve_maker(const std::string& name, ServiceThread::Urgency urgency) {
  pthread_setname_np(pthread_self(), name.substr(0, 15).c_str());
  cpu_set_t all;
  CPU_ZERO(&all);
  const unsigned processors = std::min<unsigned>(std::thread::hardware_concurrency(), CPU_SETSIZE);
  for (unsigned i = 0; i < processors; ++i) CPU_SET(i, &all);
  pthread_setaffinity_np(pthread_self(), sizeof all, &all);
  int policy = SCHED_OTHER;
  sched_param param{};
  pthread_getschedparam(pthread_self(), &policy, &param);
  if (policy != SCHED_FIFO) return;
  if (urgency == ServiceThread::Urgency::ordinary) {
    param.sched_priority = 0;
    pthread_setschedparam(pthread_self(), SCHED_OTHER, &param);
    return;
  }
  param.sched_priority = std::min(param.sched_priority + 1, sched_get_priority_max(SCHED_FIFO));
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &param);
}

}  // namespace

ServiceThread::ServiceThread(std::string name, std::function<void(const StopFlag&)> body,
                             Urgency urgency)
    : thread_([this, name = std::move(name), body = std::move(body), urgency] {
        serve_maker(name, urgency);
        body(stop_);
      }) {}

ServiceThread::~ServiceThread() {
  stop_.raise();
  thread_.join();
}

}  // namespace trocar
