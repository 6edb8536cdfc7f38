// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// A ring of records of any size from one writer to any number of readers, each with a cursor of
/// its own. The writer is wait-free, knows no reader and overwrites the oldest records; a reader
/// that falls behind is told exactly how many it missed, and never gets a torn record.
///
/// A record lies in 64-bit words: its sequence number, its size and tag, its bytes. Why none is
/// torn: the writer first moves `oldest_` behind everything that it is about to overwrite, then
/// stores words with release, then moves `written_`. A reader loads words with acquire and then
/// looks at `oldest_` again. Had it loaded one word of a newer record, that load would have
/// synchronised with the store, so the look would see the moved `oldest_`, and the copy is thrown
/// away. There is no fence, so ThreadSanitizer can follow.
class BroadcastRing {
 public:
  static constexpr std::size_t most_lossless = 64;  // cursors at a time
  static constexpr std::size_t head_size = 16;      // [bytes] that each record takes more

  /// @param capacity [bytes]; raised to what four records of the largest size take
  /// @param largest [bytes] of a record
  /// @throw std::invalid_argument when the largest has no bytes, or more than 4 GiB
  BroadcastRing(std::size_t capacity, std::size_t largest);

  // --- for the one writer ---
  /// Room for a record of `size` bytes, 8-aligned, that nobody sees before it is handed over;
  /// empty for a record of no bytes, and for one that is larger than the largest.
  std::span<std::byte> begin(std::size_t size) RT_SAFE;
  /// Hands over what begin() gave room for; wait-free.
  void commit(std::uint32_t tag) RT_SAFE;
  /// The same, but waits until no lossless cursor loses anything by it; for virtual time.
  void commit_when_read(std::uint32_t tag);

  std::size_t capacity() const { return words_.size() * 8; }  // [bytes]
  std::size_t largest() const { return largest_; }            // [bytes]

  struct Record {
    std::uint32_t tag = 0;
    std::span<const std::byte> bytes{};  // a copy, 8-aligned; until the cursor's next call
    std::uint64_t missed = 0;            // records that were overwritten before this one
  };

  /// Where a reader is. For one thread at a time.
  class Cursor {
   public:
    enum class Start { now, oldest };
    /// A lossless cursor makes commit_when_read() wait for it; it is made before the writer begins.
    enum class Loss { told, never };

    /// @throw std::length_error for more than `most_lossless` cursors that lose nothing
    explicit Cursor(BroadcastRing& ring, Start start = Start::now, Loss loss = Loss::told);
    ~Cursor() { abandon(); }
    Cursor(const Cursor&) = delete;
    Cursor& operator=(const Cursor&) = delete;

    /// The oldest record that was not read and is still there, or nothing. Wait-free: where the
    /// writer is faster again and again, it gives nothing and goes on at the newest.
    std::optional<Record> next();
    /// Reads no more, and holds nobody up.
    void abandon();

   private:
    bool copy_record(std::uint64_t& sequence, std::uint64_t& head);
    bool overwritten() const;
    void claim_slot();

    BroadcastRing& ring_;
    std::vector<std::uint64_t> copy_;
    std::uint64_t position_ = 0;  // [words] since the beginning
    std::uint64_t expected_ = 0;  // sequence number
    std::atomic<std::uint64_t>* slot_ = nullptr;
  };

 private:
  static constexpr std::uint64_t nobody = ~std::uint64_t{0};
  static std::uint64_t words_of(std::uint64_t size) { return head_size / 8 + (size + 7) / 8; }
  std::uint64_t load(std::uint64_t position) const RT_SAFE {
    return words_[position % words_.size()].load(std::memory_order_acquire);
  }
  void store(std::uint64_t position, std::span<const std::uint64_t> values) RT_SAFE;
  /// What a record that begins now and takes `words` overwrites ends before this position.
  std::uint64_t end_of_loss(std::uint64_t words) const RT_SAFE;
  std::uint64_t slowest_lossless() const RT_SAFE;

  std::vector<std::atomic<std::uint64_t>> words_;
  std::size_t largest_;
  std::array<std::atomic<std::uint64_t>, most_lossless> slots_;  // positions of lossless cursors
  // The writer's own.
  std::vector<std::uint64_t> staging_;  // head and bytes of the record that is being made
  std::size_t begun_size_ = 0;
  std::uint64_t sequence_ = 0;
  std::uint64_t read_by_all_ = 0;  // lossless cursors are here, or further
  // Positions: words since the beginning.
  alignas(64) std::atomic<std::uint64_t> oldest_{0};   // first record that is whole
  alignas(64) std::atomic<std::uint64_t> written_{0};  // the next one; its number is there already
};

}  // namespace trocar
