// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/background_poller.hpp"

#include <utility>

namespace trocar {

BackgroundPoller::BackgroundPoller(std::function<bool()> poll, std::chrono::microseconds pause)
    : poll_(std::move(poll)), pause_(pause), thread_([this] { run(); }) {}

BackgroundPoller::~BackgroundPoller() {
  stop_.raise();
  if (thread_.joinable()) thread_.join();
}

void BackgroundPoller::run() {
  try {
    while (true) {
      const bool last = stop_.raised();
      if (poll_()) continue;
      if (last) return;
      std::this_thread::sleep_for(pause_);
    }
  } catch (...) {
    error_ = std::current_exception();
    failed_.raise();
  }
}

void BackgroundPoller::finish() {
  stop_.raise();
  if (thread_.joinable()) thread_.join();
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

}  // namespace trocar
