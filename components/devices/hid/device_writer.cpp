// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/device_writer.hpp"

namespace trocar::hid {

/// Its deadline is as far off, in device time, as that of the last one was when its tick began.
PostedCommand safe_command(const PostedCommand& last, std::int64_t now_ns) RT_SAFE {
  PostedCommand safe = last;
  if (safe.command.mode != CommandMode::off) safe.command.mode = CommandMode::hold;
  safe.command.effort.fill(0);
  safe.command.acknowledge = false;
  safe.command.deadline_us += static_cast<std::uint32_t>((now_ns - last.begun_ns) / 1000);
  return safe;
}

bool DeviceWriter::serve() {
  if (auto outlet = exchange_.outlet.take()) out_ = std::move(*outlet);
  std::int64_t stalled_ns = stalled_ns_;
  if (exchange_.stalled_ns.load(stalled_ns) && stalled_ns != stalled_ns_)
    return send_safe(stalled_ns);
  PostedCommand posted;
  if (!exchange_.posted.load(posted) || posted.number == last_.number) return false;
  last_ = posted;
  if (posted.begun_ns < stalled_ns_) {
    ++written_.dropped;
    exchange_.written.store(written_);
    return true;
  }
  send(posted);
  return true;
}

bool DeviceWriter::send_safe(std::int64_t stalled_ns) {
  stalled_ns_ = stalled_ns;
  exchange_.posted.load(last_);
  if (last_.number == 0) return false;
  ++written_.safe;
  send(safe_command(last_, time_.now()));
  return true;
}

void DeviceWriter::send(const PostedCommand& posted) {
  if (out_ == nullptr) return;
  CommandReport command = posted.command;
  command.sequence = ++sequence_;
  Report report;
  encode(command, report);
  const std::int64_t begin = time_.now();
  if (!out_->write(report)) out_.reset();  // the reader finds the device again
  ++written_.written;
  written_.number = posted.number;
  written_.sequence = command.sequence;
  written_.begun_ns = posted.begun_ns;
  written_.write_ns = time_.now() - begin;
  exchange_.written.store(written_);
}

}  // namespace trocar::hid
