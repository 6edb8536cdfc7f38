// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/broadcast_ring.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

namespace trocar {
namespace {

constexpr std::uint64_t head_words = BroadcastRing::head_size / 8;
constexpr int most_attempts = 8;  // of a reader that the writer laps while it copies

std::uint64_t head_of(std::uint32_t tag, std::size_t size) {
  return std::uint64_t{tag} << 32 | size;
}
std::uint64_t size_in(std::uint64_t head) {
  return head & 0xffffffff;
}

std::size_t checked(std::size_t largest) {
  if (largest > 0 && largest <= std::numeric_limits<std::uint32_t>::max()) return largest;
  throw std::invalid_argument("a ring of records of up to " + std::to_string(largest) +
                              " bytes: 1 byte to 4 GiB is possible");
}

}  // namespace

// --- writing ----------------------------------------------------------------------------------

BroadcastRing::BroadcastRing(std::size_t capacity, std::size_t largest)
    : words_(std::max((capacity + 7) / 8, 4 * words_of(checked(largest)))),
      largest_(largest),
      staging_(words_of(largest)) {
  for (auto& slot : slots_) slot.store(nobody, std::memory_order_relaxed);
}

std::span<std::byte> BroadcastRing::begin(std::size_t size) RT_SAFE {
  if (size == 0 || size > largest_) return {};
  begun_size_ = size;
  staging_[words_of(size) - 1] = 0;  // the last word may have bytes to spare
  return {reinterpret_cast<std::byte*>(staging_.data() + head_words), size};
}

std::uint64_t BroadcastRing::end_of_loss(std::uint64_t words) const RT_SAFE {
  // One word more: the number of the record that follows is written in advance, so that a cursor
  // can begin at a place where nothing is yet and know what it will have missed.
  const std::uint64_t end = written_.load(std::memory_order_relaxed) + words + 1;
  return end > words_.size() ? end - words_.size() : 0;
}

void BroadcastRing::commit(std::uint32_t tag) RT_SAFE {
  const std::uint64_t words = words_of(begun_size_);
  const std::uint64_t begin = written_.load(std::memory_order_relaxed);
  std::uint64_t oldest = oldest_.load(std::memory_order_relaxed);
  for (const std::uint64_t end = end_of_loss(words); oldest < end;)
    oldest += words_of(size_in(load(oldest + 1)));
  oldest_.store(oldest, std::memory_order_release);
  staging_[0] = sequence_++;
  staging_[1] = head_of(tag, begun_size_);
  store(begin, {staging_.data(), words});
  store(begin + words, {&sequence_, 1});
  written_.store(begin + words, std::memory_order_release);
}

void BroadcastRing::store(std::uint64_t position, std::span<const std::uint64_t> values) RT_SAFE {
  std::size_t index = position % words_.size();
  for (const std::uint64_t value : values) {
    words_[index].store(value, std::memory_order_release);
    if (++index == words_.size()) index = 0;
  }
}

void BroadcastRing::commit_when_read(std::uint32_t tag) {
  const std::uint64_t end = end_of_loss(words_of(begun_size_));
  while (read_by_all_ < end) {
    read_by_all_ = slowest_lossless();
    if (read_by_all_ < end) std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
  commit(tag);
}

std::uint64_t BroadcastRing::slowest_lossless() const RT_SAFE {
  std::uint64_t slowest = written_.load(std::memory_order_relaxed);
  for (const auto& slot : slots_) slowest = std::min(slowest, slot.load(std::memory_order_acquire));
  return slowest;
}

// --- reading ----------------------------------------------------------------------------------

BroadcastRing::Cursor::Cursor(BroadcastRing& ring, Start start, Loss loss)
    : ring_(ring), copy_((ring.largest_ + 7) / 8) {
  const auto& first = start == Start::now ? ring.written_ : ring.oldest_;
  do {
    position_ = first.load(std::memory_order_acquire);
    expected_ = ring.load(position_);
  } while (overwritten());
  if (loss == Loss::never) claim_slot();
}

void BroadcastRing::Cursor::claim_slot() {
  for (auto& slot : ring_.slots_) {
    std::uint64_t free = nobody;
    if (!slot.compare_exchange_strong(free, position_, std::memory_order_acq_rel)) continue;
    slot_ = &slot;
    return;
  }
  throw std::length_error("a ring has at most " + std::to_string(most_lossless) +
                          " readers that lose nothing");
}

void BroadcastRing::Cursor::abandon() {
  if (slot_ != nullptr) slot_->store(nobody, std::memory_order_release);
  slot_ = nullptr;
}

bool BroadcastRing::Cursor::overwritten() const {
  return ring_.oldest_.load(std::memory_order_acquire) > position_;
}

/// Whether what was copied is what stood there.
bool BroadcastRing::Cursor::copy_record(std::uint64_t& sequence, std::uint64_t& head) {
  sequence = ring_.load(position_);
  head = ring_.load(position_ + 1);
  if (overwritten()) return false;  // before a size is believed
  const std::uint64_t words = words_of(size_in(head)) - head_words;
  std::size_t index = (position_ + head_words) % ring_.words_.size();
  for (std::uint64_t i = 0; i < words; ++i) {
    copy_[i] = ring_.words_[index].load(std::memory_order_acquire);
    if (++index == ring_.words_.size()) index = 0;
  }
  return !overwritten();
}

std::optional<BroadcastRing::Record> BroadcastRing::Cursor::next() {
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    // In this order: what is written is then never less than what is oldest.
    position_ = std::max(position_, ring_.oldest_.load(std::memory_order_acquire));
    if (position_ == ring_.written_.load(std::memory_order_acquire)) return std::nullopt;
    std::uint64_t sequence = 0;
    std::uint64_t head = 0;
    if (!copy_record(sequence, head)) continue;
    const std::uint64_t size = size_in(head);
    const Record record{static_cast<std::uint32_t>(head >> 32),
                        std::as_bytes(std::span(copy_)).first(size), sequence - expected_};
    expected_ = sequence + 1;
    position_ += words_of(size);
    if (slot_ != nullptr) slot_->store(position_, std::memory_order_release);
    return record;
  }
  position_ = ring_.written_.load(std::memory_order_acquire);
  return std::nullopt;
}

}  // namespace trocar
