// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/doorbell.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>

namespace trocar {
namespace {

long call_futex(std::atomic<std::uint32_t>& word, int operation, std::uint32_t value,
                const timespec* date) RT_SAFE {
  return syscall(SYS_futex, &word, operation | FUTEX_PRIVATE_FLAG, value, date, nullptr,
                 FUTEX_BITSET_MATCH_ANY);
}

}  // namespace

void Doorbell::ring() {
  rings_.fetch_add(1, std::memory_order_release);
  call_futex(rings_, FUTEX_WAKE, 1, nullptr);
}

std::uint32_t Doorbell::wait(std::uint32_t seen, std::int64_t date_ns) RT_SAFE {
  const timespec date{date_ns / 1'000'000'000, date_ns % 1'000'000'000};
  while (true) {
    const std::uint32_t rings = rings_.load(std::memory_order_acquire);
    if (rings != seen) return rings;
    // Returns at once when it rang meanwhile; the date is absolute.
    if (call_futex(rings_, FUTEX_WAIT_BITSET, seen, &date) != 0 && errno == ETIMEDOUT)
      return rings_.load(std::memory_order_acquire);
  }
}

}  // namespace trocar
