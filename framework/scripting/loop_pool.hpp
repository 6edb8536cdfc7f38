// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "framework/realtime/rt_safe.hpp"

namespace trocar::lua {

/// Memory of fixed size that a script in the loop lives in. Taking, growing and giving back are
/// bounded whatever came before (growing may copy); freed neighbours are joined at once.
///
/// Two-level segregated fit: 16 lists of free blocks for each power of two (Masmano, Ripoll,
/// Crespo, Real, "TLSF: a new dynamic memory allocator for real-time systems", ECRTS 2004).
class LoopPool {
 public:
  /// @param size [bytes], blocks' headers included; touched at once
  explicit LoopPool(std::size_t size);
  LoopPool(const LoopPool&) = delete;
  LoopPool& operator=(const LoopPool&) = delete;

  /// Null when no free block is long enough. Aligned to 16 bytes.
  void* take(std::size_t size) RT_SAFE;
  /// The block with at least `size` bytes, moved where it must be; null, and the block as it was,
  /// when that cannot be. Never null when it shrinks.
  void* resize(void* block, std::size_t size) RT_SAFE;
  void give_back(void* block) RT_SAFE;

  /// [bytes] in use, headers included.
  std::size_t used() const RT_SAFE { return used_; }

 private:
  static constexpr std::size_t grain = 16;
  static constexpr int steps = 16;   // lists for each power of two
  static constexpr int powers = 24;  // from below 256 bytes to 2 GiB

  struct Block {
    Block* before;      // the neighbour, null for the first
    std::size_t state;  // bytes of the payload; bit 0: in use
    // While it is free, these lie in its payload.
    Block* next;
    Block* previous;
    std::size_t size() const { return state & ~std::size_t{1}; }
    bool in_use() const { return (state & 1) != 0; }
  };
  static constexpr std::size_t header = 16;
  struct List {
    int power;
    int step;
  };

  static List list_of(std::size_t size) RT_SAFE;
  static Block* block_of(void* payload) RT_SAFE;
  static void* payload_of(Block* block) RT_SAFE;
  static Block* after(Block* block) RT_SAFE;
  Block* find(std::size_t size) RT_SAFE;
  void insert(Block* block) RT_SAFE;
  void remove(Block* block) RT_SAFE;
  void use(Block* block, std::size_t size) RT_SAFE;
  void cut(Block* block, std::size_t size) RT_SAFE;
  void release(Block* block) RT_SAFE;

  std::vector<std::max_align_t> memory_;
  std::array<std::array<Block*, steps>, powers> free_{};
  std::array<std::uint32_t, powers> steps_with_free_{};
  std::uint32_t powers_with_free_ = 0;
  std::size_t used_ = 0;
};

}  // namespace trocar::lua
