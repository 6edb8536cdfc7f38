// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/command_report.hpp"
#include "components/devices/hid/link.hpp"
#include "components/devices/hid/report_check.hpp"
#include "framework/realtime/doorbell.hpp"
#include "framework/realtime/handover.hpp"
#include "framework/realtime/latest.hpp"

namespace trocar::hid {

/// What is known of the device, by the thread that reads.
struct DeviceSnapshot {
  bool connected = false;
  const char* trouble = "no report yet";  // not connected, or why the last report was not used
  bool any = false;                       // `state` was taken since the device was connected
  bool jumped = false;                    // its position is not to be used until homed anew
  StateReport state{};
  std::int64_t device_us = 0;     // of `state`, does not wrap
  std::int64_t arrival_ns = 0;    // of `state`, on the host's monotonic clock
  std::int64_t under_way_ns = 0;  // that it was longer on its way than the fastest
  std::int64_t heard_ns = 0;      // when the last plausible report arrived, taken or not
  std::int64_t received = 0;      // reports of any kind
  std::int64_t lost = 0, repeated = 0, refused = 0;
  std::int64_t connections = 0;
};

/// What the loop wants to be sent, of one tick.
struct PostedCommand {
  CommandReport command{};    // without its sequence
  std::int64_t number = 0;    // one more each tick
  std::int64_t begun_ns = 0;  // when its tick began, on the host's monotonic clock
};

/// What became of it, by the thread that writes.
struct WrittenCommand {
  std::int64_t number = 0;
  std::uint16_t sequence = 0;
  std::int64_t begun_ns = 0;
  std::int64_t write_ns = 0;  // that the write took
  std::int64_t written = 0;   // commands, in all
  std::int64_t safe = 0;      // of them, in place of a loop that hung
  std::int64_t dropped = 0;   // of a tick that hung, and not sent
};

/// Where the loop, the reader, the writer and the supervisor of one device meet. Each member has
/// one writer.
struct DeviceExchange {
  Latest<DeviceSnapshot> snapshot;         // reader to all
  Latest<PostedCommand> posted;            // loop to writer
  Latest<WrittenCommand> written;          // writer to loop
  Latest<std::int64_t> stalled_ns;         // supervisor to writer: when the loop was given up
  Doorbell arrival;                        // reader to a loop that is paced, at each snapshot
  Handover<std::unique_ptr<Link>> outlet;  // reader to writer, after each opening
};

}  // namespace trocar::hid
