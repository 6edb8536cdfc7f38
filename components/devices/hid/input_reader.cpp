// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/input_reader.hpp"

#include <algorithm>
#include <exception>

namespace trocar::hid {
namespace {

// Looking for it lists all that is attached, which is much more work than a report.
constexpr std::int64_t look_for_it_ns = 1'000'000'000;

}  // namespace

/// Room for a report that is longer than any of the layout's: it is taken as far as fields go.
InputReader::InputReader(LinkSource& source, TimeSource& time, const DeviceLayout& layout,
                         Latest<InputSnapshot>& to)
    : source_(source), time_(time), layout_(layout), to_(to), bytes_(largest_report) {
  snapshot_.begin(layout);
  to_.store(snapshot_);
}

/// It is only read from: the other end is closed.
void InputReader::open() {
  try_again_ns_ = time_.now() + look_for_it_ns;
  in_ = source_.open().in;
  snapshot_.attach();
  to_.store(snapshot_);
}

bool InputReader::serve(int timeout_ms) {
  if (in_ == nullptr) return reopen(timeout_ms);
  const int size = in_->read(bytes_, timeout_ms);
  if (size == 0) return false;
  if (size > 0) {
    snapshot_.take(layout_.fields, std::span(bytes_).first(static_cast<std::size_t>(size)),
                   time_.now());
  } else {
    in_.reset();
    snapshot_.detach();
  }
  to_.store(snapshot_);
  return true;
}

bool InputReader::reopen(int timeout_ms) {
  const std::int64_t now = time_.now();
  if (now < try_again_ns_) {
    if (timeout_ms > 0)
      time_.sleep_until(std::min(try_again_ns_, now + std::int64_t{timeout_ms} * 1'000'000));
    return false;
  }
  try {
    open();
    return true;
  } catch (const std::exception&) {
    return false;  // not there yet, or not ready
  }
}

}  // namespace trocar::hid
