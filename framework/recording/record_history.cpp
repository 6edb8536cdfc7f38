// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/record_history.hpp"

#include <cstring>
#include <stdexcept>
#include <string>

namespace trocar {
namespace {

constexpr std::uint32_t go_round = 0xffffffff;  // a size: the record is at the memory's start

}  // namespace

RecordHistory::RecordHistory(std::size_t capacity) : memory_((capacity + 7) / 8 * 8) {}

/// The head at a position, which moves to where the record is.
RecordHistory::Head RecordHistory::head_at(std::uint64_t& position) const {
  Head head;
  std::memcpy(&head, memory_.data() + index(position), sizeof head);
  if (head.size != go_round) return head;
  position += memory_.size() - index(position);
  std::memcpy(&head, memory_.data(), sizeof head);
  return head;
}

void RecordHistory::push(std::uint32_t tag, std::span<const std::byte> record) {
  const std::size_t need = taken_by(record.size());
  if (need > memory_.size() / 2)
    throw std::length_error("a record of " + std::to_string(record.size()) +
                            " bytes for a history of " + std::to_string(memory_.size()) +
                            ": half of that is possible");
  const std::uint64_t place = place_for(end_, need);
  while (kept_ > 0 && place + need - begin_ > memory_.size()) {
    const Head oldest = head_at(begin_);
    begin_ = behind(begin_, oldest);
    --kept_;
  }
  if (place != end_) {
    const Head round{go_round, tag};
    std::memcpy(memory_.data() + index(end_), &round, sizeof round);
  }
  if (kept_ == 0) begin_ = place;
  const Head head{static_cast<std::uint32_t>(record.size()), tag};
  std::memcpy(memory_.data() + index(place), &head, sizeof head);
  std::memcpy(memory_.data() + index(place) + sizeof head, record.data(), record.size());
  end_ = place + need;
  ++pushed_;
  ++kept_;
}

}  // namespace trocar
