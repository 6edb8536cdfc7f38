// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/device_line.hpp"

#include <algorithm>

namespace trocar::hid {
namespace {

constexpr int read_timeout_ms = 20;                 // until the thread sees that it is to end
constexpr std::int64_t longest_pause_ns = 500'000;  // a hung loop is to be noticed in time

}  // namespace

DeviceLine::DeviceLine(std::unique_ptr<LinkSource> source, TimeSource& time,
                       DeviceLineSettings settings)
    : source_(std::move(source)),
      time_(time),
      settings_(std::move(settings)),
      reader_(*source_, time, exchange_, settings_.oldest_ns),
      writer_(time, exchange_) {}

DeviceLine::~DeviceLine() {
  stop();
}

const LaparoscopePages& DeviceLine::open() {
  const LaparoscopePages& pages = reader_.open();
  period_ns_ = std::int64_t{pages.identity.period_us} * 1000;
  return pages;
}

void DeviceLine::start() {
  if (!settings_.threads) return;
  reading_.emplace("read " + settings_.name, [this](const StopFlag& stop) {
    while (!stop.raised()) reader_.serve(read_timeout_ms);
  });
  writing_.emplace("write " + settings_.name, [this](const StopFlag& stop) { write_until(stop); });
}

/// Nobody wakes it, since that would cost the loop more than the post itself. After a command the
/// next is a period away; it looks more often towards the end of that.
void DeviceLine::write_until(const StopFlag& stop) {
  const std::int64_t pause = std::clamp<std::int64_t>(settings_.period_ns / 16, 20'000, 100'000);
  const std::int64_t rest =
      std::clamp<std::int64_t>(settings_.period_ns * 3 / 4, pause, longest_pause_ns);
  while (!stop.raised()) {
    const bool wrote = writer_.serve();
    time_.sleep_until(time_.now() + (wrote ? rest : pause));
  }
  writer_.serve();
}

void DeviceLine::stop() {
  if (!settings_.threads) writer_.serve();
  writing_.reset();
  reading_.reset();
}

const DeviceSnapshot& DeviceLine::snapshot() RT_SAFE {
  if (!settings_.threads)
    while (reader_.serve(0)) {
    }
  exchange_.snapshot.load(snapshot_);
  return snapshot_;
}

const WrittenCommand& DeviceLine::written() RT_SAFE {
  exchange_.written.load(written_);
  return written_;
}

/// Other reports ring as well, and leave the device's time as it was.
bool DeviceLine::wait_for_beat(std::int64_t date_ns, Beat& beat) RT_SAFE {
  while (true) {
    const std::uint32_t rings = exchange_.arrival.wait(rings_, date_ns);
    const bool rang = rings != rings_;
    rings_ = rings;
    DeviceSnapshot newest;
    if (exchange_.snapshot.load(newest) && newest.any && newest.device_us * 1000 != beat_own_ns_) {
      beat_own_ns_ = newest.device_us * 1000;
      beat = {beat_own_ns_, newest.arrival_ns};
      return true;
    }
    if (!rang) return false;
  }
}

void DeviceLine::post(const PostedCommand& command) RT_SAFE {
  exchange_.posted.store(command);
  if (!settings_.threads) writer_.serve();
}

}  // namespace trocar::hid
