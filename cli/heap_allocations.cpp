// SPDX-License-Identifier: Apache-2.0
#include "cli/heap_allocations.hpp"

#include <cstdlib>
#include <new>

namespace trocar::cli {
namespace {

thread_local std::uint64_t allocations = 0;

/// As the language wants it: asks the new-handler until there is memory, or there is no handler.
template <typename Get>
void* allocate(const Get& get) {
  ++allocations;
  while (true) {
    if (void* block = get()) return block;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

}  // namespace

std::uint64_t heap_allocations() RT_SAFE {
  return allocations;
}

}  // namespace trocar::cli

// The library's other forms, of arrays and those that do not throw, call these.
void* operator new(std::size_t size) {
  return trocar::cli::allocate([&] { return std::malloc(size == 0 ? 1 : size); });
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto unit = static_cast<std::size_t>(alignment);
  const std::size_t whole = (size + unit - 1) / unit * unit;
  return trocar::cli::allocate(
      [&] { return whole < size ? nullptr : std::aligned_alloc(unit, whole == 0 ? unit : whole); });
}

void operator delete(void* block) noexcept {
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}

void operator delete(void* block, std::align_val_t) noexcept {
  std::free(block);
}

void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  std::free(block);
}
