// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/input_line.hpp"

namespace trocar::hid {
namespace {

constexpr int look_at_stop_ms = 20;

}  // namespace

void InputLine::start(const std::string& name) {
  if (!thread_) return;
  reading_.emplace(
      "read " + name,
      [this](const StopFlag& stop) {
        while (!stop.raised()) reader_.serve(look_at_stop_ms);
      },
      ServiceThread::Urgency::ordinary);
}

void InputLine::load(InputSnapshot& snapshot) RT_SAFE {
  if (!thread_)
    while (reader_.serve(0)) {
    }
  slot_.load(snapshot);
}

}  // namespace trocar::hid
