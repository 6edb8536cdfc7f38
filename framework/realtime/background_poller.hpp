// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <thread>

#include "framework/realtime/stop_flag.hpp"

namespace trocar {

/// An ordinary thread that calls `poll` again and again. Nobody wakes it, so that nobody pays for
/// waking it: when a call found nothing to do it sleeps for `pause`.
class BackgroundPoller {
 public:
  /// @param poll returns whether it found something to do; what it throws, finish() rethrows
  explicit BackgroundPoller(std::function<bool()> poll,
                            std::chrono::microseconds pause = std::chrono::milliseconds(1));
  ~BackgroundPoller();
  BackgroundPoller(const BackgroundPoller&) = delete;
  BackgroundPoller& operator=(const BackgroundPoller&) = delete;

  /// Polls until nothing is left, ends the thread and rethrows what went wrong in it.
  void finish();
  /// It threw and polls no more.
  bool failed() const { return failed_.raised(); }

 private:
  void run();
  std::function<bool()> poll_;
  std::chrono::microseconds pause_;
  StopFlag stop_;
  StopFlag failed_;
  std::exception_ptr error_;
  std::thread thread_;
};

}  // namespace trocar
