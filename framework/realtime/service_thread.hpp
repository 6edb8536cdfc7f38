// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <thread>

#include "framework/realtime/stop_flag.hpp"

namespace trocar {

/// A thread that serves a loop, such as one that waits for a device in its place. It is more urgent
/// than the thread that makes it, by one step of SCHED_FIFO, where that one is real-time, and runs
/// on any processor; else it is an ordinary thread.
class ServiceThread {
 public:
  /// @param body ends soon after the flag is raised, and throws nothing
  ServiceThread(std::string name, std::function<void(const StopFlag&)> body);
  ~ServiceThread();
  ServiceThread(const ServiceThread&) = delete;
  ServiceThread& operator=(const ServiceThread&) = delete;

 private:
  StopFlag stop_;
  std::thread thread_;
};

}  // namespace trocar
