// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace trocar {

/// As long as one of these lives, the processors do not enter sleep states that take time to leave:
/// it keeps /dev/cpu_dma_latency open with 0 µs written to it (Linux, power management quality of
/// service). The price is power, on all processors.
class CpuLatencyHold {
 public:
  explicit CpuLatencyHold(const std::string& file = "/dev/cpu_dma_latency");
  ~CpuLatencyHold();
  CpuLatencyHold(const CpuLatencyHold&) = delete;
  CpuLatencyHold& operator=(const CpuLatencyHold&) = delete;

  bool held() const { return descriptor_ >= 0; }
  /// Why it is not held, and the cure; "" when it is.
  const std::string& shortcoming() const { return shortcoming_; }

 private:
  int descriptor_ = -1;
  std::string shortcoming_;
};

}  // namespace trocar
