// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/record_ring.hpp"

#include <bit>
#include <chrono>
#include <cstring>
#include <thread>

namespace trocar {

RecordRing::RecordRing(std::size_t capacity) : buffer_(std::bit_ceil(capacity) / 8) {}

std::span<std::byte> RecordRing::try_begin(std::size_t size) RT_SAFE {
  if (!can_ever_fit(size)) return {};
  std::size_t begin = written_.load(std::memory_order_relaxed);
  const std::size_t read = read_.load(std::memory_order_acquire);
  const std::size_t need = padded(size);
  const std::size_t to_end = capacity() - index(begin);
  const std::size_t skipped = need > to_end ? to_end : 0;
  if (begin + skipped + need - read > capacity()) return {};
  if (skipped > 0) {
    const Header marker{wrap, 0};
    std::memcpy(at(begin), &marker, sizeof marker);
    begin += skipped;
  }
  begun_ = begin;
  begun_size_ = static_cast<std::uint32_t>(size);
  return {at(begin) + sizeof(Header), size};
}

std::span<std::byte> RecordRing::begin(std::size_t size) {
  while (can_ever_fit(size) && !abandoned_.raised()) {
    if (const std::span<std::byte> room = try_begin(size); !room.empty()) return room;
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
  return {};
}

void RecordRing::commit(std::uint32_t kind) RT_SAFE {
  const Header header{begun_size_, kind};
  std::memcpy(at(begun_), &header, sizeof header);
  written_.store(begun_ + padded(begun_size_), std::memory_order_release);
}

RecordRing::Record RecordRing::front() const RT_SAFE {
  std::size_t read = read_.load(std::memory_order_relaxed);
  const std::size_t written = written_.load(std::memory_order_acquire);
  if (read == written) return {};
  Header header;
  std::memcpy(&header, at(read), sizeof header);
  if (header.size == wrap) {
    read += capacity() - index(read);
    std::memcpy(&header, at(read), sizeof header);
  }
  return {header.kind, {at(read) + sizeof(Header), header.size}};
}

void RecordRing::pop() RT_SAFE {
  std::size_t read = read_.load(std::memory_order_relaxed);
  Header header;
  std::memcpy(&header, at(read), sizeof header);
  if (header.size == wrap) {
    read += capacity() - index(read);
    std::memcpy(&header, at(read), sizeof header);
  }
  read_.store(read + padded(header.size), std::memory_order_release);
}

}  // namespace trocar
