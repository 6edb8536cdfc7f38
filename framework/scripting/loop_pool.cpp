// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/loop_pool.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace trocar::lua {
namespace {

constexpr std::size_t smallest_power = 256;  // below it, one list for each multiple of the grain

std::size_t rounded(std::size_t size, std::size_t grain) RT_SAFE {
  return (std::max(size, grain) + grain - 1) & ~(grain - 1);
}

}  // namespace

LoopPool::LoopPool(std::size_t size) {
  static_assert(sizeof(std::max_align_t) % grain == 0 && alignof(std::max_align_t) >= grain);
  const std::size_t whole = std::max(rounded(size, grain), 4 * header);
  memory_.resize(whole / sizeof(std::max_align_t) + 1);
  auto* first = reinterpret_cast<Block*>(memory_.data());
  first->before = nullptr;
  first->state = whole - 2 * header;
  Block* end = after(first);  // in use for ever, so that nothing is joined beyond it
  end->before = first;
  end->state = 1;
  insert(first);
}

LoopPool::List LoopPool::list_of(std::size_t size) RT_SAFE {
  if (size < smallest_power) return {0, static_cast<int>(size / grain)};
  const int top = static_cast<int>(std::bit_width(size)) - 1;
  return {top - 7, static_cast<int>((size >> (top - 4)) & (steps - 1))};
}

LoopPool::Block* LoopPool::block_of(void* payload) RT_SAFE {
  return reinterpret_cast<Block*>(static_cast<std::byte*>(payload) - header);
}

void* LoopPool::payload_of(Block* block) RT_SAFE {
  return reinterpret_cast<std::byte*>(block) + header;
}

LoopPool::Block* LoopPool::after(Block* block) RT_SAFE {
  return reinterpret_cast<Block*>(reinterpret_cast<std::byte*>(block) + header + block->size());
}

void LoopPool::insert(Block* block) RT_SAFE {
  const auto [power, step] = list_of(block->size());
  const auto p = static_cast<std::size_t>(power), s = static_cast<std::size_t>(step);
  block->previous = nullptr;
  block->next = free_[p][s];
  if (block->next != nullptr) block->next->previous = block;
  free_[p][s] = block;
  steps_with_free_[p] |= 1u << step;
  powers_with_free_ |= 1u << power;
}

void LoopPool::remove(Block* block) RT_SAFE {
  const auto [power, step] = list_of(block->size());
  const auto p = static_cast<std::size_t>(power), s = static_cast<std::size_t>(step);
  if (block->next != nullptr) block->next->previous = block->previous;
  if (block->previous != nullptr) {
    block->previous->next = block->next;
    return;
  }
  free_[p][s] = block->next;
  if (block->next != nullptr) return;
  steps_with_free_[p] &= ~(1u << step);
  if (steps_with_free_[p] == 0) powers_with_free_ &= ~(1u << power);
}

/// The first block of a list in which every one is long enough.
LoopPool::Block* LoopPool::find(std::size_t size) RT_SAFE {
  if (size >= smallest_power) size += (std::size_t{1} << (std::bit_width(size) - 5)) - 1;
  const auto [power, step] = list_of(size);
  if (power >= powers) return nullptr;
  auto p = static_cast<std::size_t>(power);
  std::uint32_t fitting = steps_with_free_[p] & (~0u << step);
  if (fitting == 0) {
    const std::uint32_t longer = powers_with_free_ & (~0u << power << 1);
    if (longer == 0) return nullptr;
    p = static_cast<std::size_t>(std::countr_zero(longer));
    fitting = steps_with_free_[p];
  }
  return free_[p][static_cast<std::size_t>(std::countr_zero(fitting))];
}

/// Gives back what a block has beyond `size`, where that makes a block.
void LoopPool::cut(Block* block, std::size_t size) RT_SAFE {
  if (block->size() < size + header + grain) return;
  const std::size_t rest = block->size() - size - header;
  block->state = size | (block->state & 1);
  Block* tail = after(block);
  tail->before = block;
  tail->state = rest | 1;
  after(tail)->before = tail;
  release(tail);
}

void LoopPool::use(Block* block, std::size_t size) RT_SAFE {
  remove(block);
  block->state |= 1;
  cut(block, size);
}

/// Makes it free, joined with what is free beside it. `used_` is the caller's business.
void LoopPool::release(Block* block) RT_SAFE {
  block->state = block->size();
  if (Block* next = after(block); !next->in_use()) {
    remove(next);
    block->state += header + next->size();
  }
  if (Block* before = block->before; before != nullptr && !before->in_use()) {
    remove(before);
    before->state += header + block->size();
    block = before;
  }
  after(block)->before = block;
  insert(block);
}

void* LoopPool::take(std::size_t size) RT_SAFE {
  size = rounded(size, grain);
  Block* block = find(size);
  if (block == nullptr) return nullptr;
  use(block, size);
  used_ += header + block->size();
  return payload_of(block);
}

void LoopPool::give_back(void* payload) RT_SAFE {
  if (payload == nullptr) return;
  Block* block = block_of(payload);
  used_ -= header + block->size();
  release(block);
}

void* LoopPool::resize(void* payload, std::size_t size) RT_SAFE {
  Block* block = block_of(payload);
  const std::size_t had = block->size();
  size = rounded(size, grain);
  Block* next = after(block);
  if (size > had && !next->in_use() && had + header + next->size() >= size) {
    remove(next);
    block->state += header + next->size();
    after(block)->before = block;
  }
  if (size <= block->size()) {
    cut(block, size);
    used_ = used_ + block->size() - had;
    return payload;
  }
  void* moved = take(size);
  if (moved == nullptr) return nullptr;
  std::memcpy(moved, payload, had);
  give_back(payload);
  return moved;
}

}  // namespace trocar::lua
