// SPDX-License-Identifier: Apache-2.0
#include "framework/crossing.hpp"

#include <algorithm>
#include <cstring>

namespace trocar {

Crossing::Crossing(const Connection& connection, std::span<const std::byte> source,
                   const Target& target, std::string text)
    : connection_(connection),
      text_(std::move(text)),
      source_(source),
      target_(target),
      outgoing_(sizeof(Head) + source.size()),
      incoming_(outgoing_.size()) {
  if (connection.kind == Connection::Kind::latest)
    latest_.emplace(outgoing_.size());
  else
    queue_.emplace(outgoing_.size(), connection.size);
  std::memcpy(target_.value, source.data(), source.size());
  *target_.tick = info_.tick;
  *target_.valid = info_.valid;
}

bool Crossing::send(const Tick& tick, bool sound) RT_SAFE {
  const Head head{tick.index, tick.time_ns, sound ? 1 : 0};
  std::memcpy(outgoing_.data(), &head, sizeof head);
  std::memcpy(outgoing_.data() + sizeof head, source_.data(), source_.size());
  if (queue_) return queue_->try_push(tick.time_ns, outgoing_);
  latest_->store(tick.time_ns, outgoing_);
  return true;
}

bool Crossing::take(std::int64_t before) RT_SAFE {
  if (queue_) return queue_->try_pop(before, incoming_);
  return latest_->load(before, incoming_);
}

void Crossing::receive(const Tick& tick, bool simulated) RT_SAFE {
  info_.fresh = false;
  if (take(simulated ? tick.time_ns : std::numeric_limits<std::int64_t>::max())) {
    std::memcpy(&head_, incoming_.data(), sizeof head_);
    info_.fresh = head_.tick != info_.tick;
    info_.tick = head_.tick;
    if (info_.fresh) std::memcpy(target_.value, incoming_.data() + sizeof head_, source_.size());
  }
  const std::int64_t age_ns = std::max<std::int64_t>(0, tick.time_ns - head_.time_ns);
  info_.age = static_cast<double>(age_ns) * 1e-9;
  lost_ = nullptr;
  if (info_.age > connection_.stale)
    lost_ = "stale";
  else if (head_.sound == 0)
    lost_ = "computed from values that are not sound";
  info_.valid = info_.tick >= 0 && lost_ == nullptr;
  *target_.tick = info_.tick;
  *target_.valid = info_.valid;
}

}  // namespace trocar
