// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/cpu_latency_hold.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace trocar {

CpuLatencyHold::CpuLatencyHold(const std::string& file) {
  constexpr std::int32_t allowed = 0;  // [µs]
  descriptor_ = open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor_ >= 0 && write(descriptor_, &allowed, sizeof allowed) == sizeof allowed) return;
  const int error = errno;
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
  shortcoming_ =
      "processors may sleep deeply, " + file + " is not held (" + std::strerror(error) + "): ";
  shortcoming_ += error == ENOENT
                      ? "this kernel has no such device (CONFIG_CPU_IDLE)"
                      : "give it to your group by a udev rule, KERNEL==\"cpu_dma_latency\", "
                        "GROUP=\"realtime\", MODE=\"0660\"";
}

CpuLatencyHold::~CpuLatencyHold() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace trocar
