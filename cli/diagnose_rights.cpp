// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <pwd.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "cli/diagnosis.hpp"

namespace trocar::cli {
namespace {

using Level = Diagnosis::Level;

constexpr int wanted_priority = 81;  // of the driver's threads; the loop has 80

std::string user() {
  const passwd* entry = getpwuid(geteuid());
  return entry != nullptr ? entry->pw_name : std::to_string(geteuid());
}

std::string limit_cure(const char* limit) {
  return fmt::format(
      "echo '{} - {}' | sudo tee -a /etc/security/limits.d/90-trocar.conf    # then log in again",
      user(), limit);
}

std::string limit_text(decltype(RLIMIT_RTPRIO) which) {
  rlimit limit{};
  if (getrlimit(which, &limit) != 0) return "not readable";
  return limit.rlim_cur == RLIM_INFINITY ? "unlimited" : std::to_string(limit.rlim_cur);
}

Diagnosis priority() {
  sched_param before{}, wanted{};
  sched_getparam(0, &before);
  const int policy = sched_getscheduler(0);
  wanted.sched_priority = wanted_priority;
  const int error = sched_setscheduler(0, SCHED_FIFO, &wanted) == 0 ? 0 : errno;
  if (error == 0) sched_setscheduler(0, policy, &before);
  if (error == 0)
    return {"rtprio", Level::good, fmt::format("real-time priority {} is allowed", wanted_priority),
            ""};
  return {"rtprio", Level::problem,
          fmt::format("no real-time priority {} ({}; limit {}): whatever else runs delays the loop",
                      wanted_priority, std::strerror(error), limit_text(RLIMIT_RTPRIO)),
          limit_cure("rtprio 90")};
}

Diagnosis memory() {
  if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) {
    munlockall();
    return {"memlock", Level::good, "memory may be locked", ""};
  }
  return {"memlock", Level::problem,
          fmt::format("memory may not be locked ({}; limit {} B): a page that was swapped out "
                      "delays the loop",
                      std::strerror(errno), limit_text(RLIMIT_MEMLOCK)),
          limit_cure("memlock unlimited")};
}

/// Of --hold-latency.
Diagnosis sleep_of_processors(const std::string& root) {
  const std::string file = root + "/dev/cpu_dma_latency";
  if (faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS) == 0)
    return {"cpu_dma_latency", Level::good, "processors can be kept from deep sleep", ""};
  if (errno == ENOENT)
    return {"cpu_dma_latency", Level::good, "the kernel lets no processor sleep deeply", ""};
  return {
      "cpu_dma_latency", Level::note,
      fmt::format("processors cannot be kept from deep sleep, as --hold-latency does: {} may "
                  "not be written ({})",
                  file, std::strerror(errno)),
      fmt::format("sudo groupadd -f realtime && sudo usermod -aG realtime {}\n"
                  "echo 'KERNEL==\"cpu_dma_latency\", GROUP=\"realtime\", MODE=\"0660\"' | "
                  "sudo tee /etc/udev/rules.d/71-trocar-latency.rules\n"
                  "sudo udevadm control --reload && sudo udevadm trigger    # then log in again",
                  user())};
}

}  // namespace

std::vector<Diagnosis> diagnose_rights(const std::string& root) {
  return {priority(), memory(), sleep_of_processors(root)};
}

}  // namespace trocar::cli
