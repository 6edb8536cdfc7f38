// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/parallel_for.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace trocar {
namespace {

/// The pieces that are left, and what went wrong in those that are done.
class Pieces {
 public:
  Pieces(std::size_t count, const std::function<void(std::size_t)>& work)
      : count_(count), first_failed_(count), work_(work) {}

  /// Does the next piece; false when none is left.
  bool do_one() {
    const std::size_t index = next_.fetch_add(1, std::memory_order_relaxed);
    if (index >= count_) return false;
    try {
      work_(index);
    } catch (...) {
      note_error(index, std::current_exception());
      next_.store(count_, std::memory_order_relaxed);
    }
    done_.fetch_add(1, std::memory_order_relaxed);
    return true;
  }

  std::size_t done() const { return done_.load(std::memory_order_relaxed); }

  /// Once all threads have ended.
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void note_error(std::size_t index, std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (index >= first_failed_) return;
    first_failed_ = index;
    error_ = std::move(error);
  }

  std::size_t count_;
  std::size_t first_failed_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
  std::exception_ptr error_;
};

}  // namespace

void parallel_for(std::size_t count, const ParallelOptions& options,
                  const std::function<void(std::size_t)>& work) {
  Pieces pieces(count, work);
  const std::size_t wanted =
      options.threads != 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> helpers;
  for (std::size_t i = 1; i < std::min(wanted, count); ++i)
    helpers.emplace_back([&pieces] {
      while (pieces.do_one()) {
      }
    });
  while (pieces.do_one())
    if (options.progress) options.progress(pieces.done(), count);
  helpers.clear();  // joins
  pieces.rethrow();
}

}  // namespace trocar
