// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "components/devices/hid/device_reader.hpp"
#include "components/devices/hid/device_writer.hpp"
#include "framework/pacer.hpp"
#include "framework/realtime/service_thread.hpp"

namespace trocar::hid {

struct DeviceLineSettings {
  std::string name;  // of the component, for the threads
  std::int64_t oldest_ns = 5'000'000;
  std::int64_t period_ns = 1'000'000;  // of the loop
  bool threads = true;  // without, the loop itself reads and writes and nothing waits: for tests
};

/// The loop's end of the way to one device. With threads nothing here waits; the loop neither locks
/// nor allocates.
class DeviceLine final : public Pacer {
 public:
  /// @param time outlives it
  DeviceLine(std::unique_ptr<LinkSource> source, TimeSource& time, DeviceLineSettings settings);
  ~DeviceLine() override;
  DeviceLine(const DeviceLine&) = delete;
  DeviceLine& operator=(const DeviceLine&) = delete;

  /// Finds the device. @throw std::runtime_error as DeviceReader::open
  const LaparoscopePages& open();
  /// Reads and writes from now on.
  void start();
  /// Writes what is posted, and ends.
  void stop();

  /// The newest that is known.
  const DeviceSnapshot& snapshot() RT_SAFE;
  const WrittenCommand& written() RT_SAFE;
  void post(const PostedCommand& command) RT_SAFE;
  /// By the supervisor.
  void loop_stalled() { exchange_.stalled_ns.store(time_.now()); }
  std::int64_t now() const RT_SAFE { return time_.now(); }

  /// Of the device's state reports; where there are threads.
  std::int64_t period_ns() const override { return period_ns_; }
  bool wait_for_beat(std::int64_t date_ns, Beat& beat) RT_SAFE override;

 private:
  void write_until(const StopFlag& stop);

  std::unique_ptr<LinkSource> source_;
  TimeSource& time_;
  DeviceLineSettings settings_;
  DeviceExchange exchange_;
  DeviceReader reader_;
  DeviceWriter writer_;
  DeviceSnapshot snapshot_;
  WrittenCommand written_;
  std::int64_t period_ns_ = 0;
  std::uint32_t rings_ = 0;        // heard
  std::int64_t beat_own_ns_ = -1;  // given last
  std::optional<ServiceThread> reading_, writing_;
};

}  // namespace trocar::hid
