// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <thread>

#include "framework/realtime/stop_flag.hpp"

namespace trocar {

/// A thread that serves a loop, such as one that waits for a device in its place, on any processor.
class ServiceThread {
 public:
  enum class Urgency {
    above_maker,  // by one step of SCHED_FIFO than the thread that makes it, if that is real-time
    ordinary      // for what the loop can do without
  };

  /// @param body ends soon after the flag is raised, and throws nothing
  ServiceThread(std::string name, std::function<void(const StopFlag&)> body,
                Urgency urgency = Urgency::above_maker);
  ~ServiceThread();
  ServiceThread(const ServiceThread&) = delete;
  ServiceThread& operator=(const ServiceThread&) = delete;

 private:
  StopFlag stop_;
  std::thread thread_;
};

}  // namespace trocar
