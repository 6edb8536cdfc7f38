// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/loop_pool.hpp"

#include <QTest>
#include <cstring>
#include <map>
#include <random>
#include <vector>

#include "tests/support/allocation_counter.hpp"

using trocar::lua::LoopPool;

namespace {

constexpr std::size_t size = 64 * 1024;

/// Blocks whose every byte says whose they are.
class Marked {
 public:
  explicit Marked(LoopPool& pool) : pool_(pool) {}
  bool take(std::size_t n) {
    void* block = pool_.take(n);
    if (block == nullptr) return false;
    mark(block, n);
    return true;
  }
  bool resize(std::size_t which, std::size_t n) {
    const auto found = std::next(blocks_.begin(), static_cast<std::ptrdiff_t>(which));
    const auto [block, had] = *found;
    void* moved = pool_.resize(block, n);
    if (moved == nullptr) return false;
    blocks_.erase(found);
    const auto* bytes = static_cast<const unsigned char*>(moved);
    for (std::size_t i = 0; i < std::min(n, had.size); ++i)
      if (bytes[i] != had.mark) wrong = true;
    mark(moved, n);
    return true;
  }
  void give_back(std::size_t which) {
    const auto found = std::next(blocks_.begin(), static_cast<std::ptrdiff_t>(which));
    pool_.give_back(found->first);
    blocks_.erase(found);
  }
  /// Nobody wrote into another's block, and no two overlap.
  bool sound() const {
    const unsigned char* end = nullptr;
    for (const auto& [block, has] : blocks_) {
      const auto* bytes = static_cast<const unsigned char*>(block);
      if (bytes < end || reinterpret_cast<std::uintptr_t>(block) % 16 != 0) return false;
      end = bytes + has.size;
      for (std::size_t i = 0; i < has.size; ++i)
        if (bytes[i] != has.mark) return false;
    }
    return !wrong;
  }
  std::size_t count() const { return blocks_.size(); }

 private:
  struct Block {
    std::size_t size;
    unsigned char mark;
  };
  void mark(void* block, std::size_t n) {
    std::memset(block, ++last_, n);
    blocks_[block] = {n, last_};
  }
  LoopPool& pool_;
  std::map<void*, Block> blocks_;
  unsigned char last_ = 0;
  bool wrong = false;
};

}  // namespace

class TestLoopPool : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void all_of_it_can_be_taken_at_once() {
    LoopPool pool(size);
    void* all = pool.take(size - 64 - size / 16);
    QVERIFY(all != nullptr);
    QVERIFY(pool.take(size / 2) == nullptr);
    pool.give_back(all);
    QCOMPARE(pool.used(), std::size_t{0});
  }

  void what_was_given_back_in_any_order_is_whole_again() {
    LoopPool pool(size);
    std::vector<void*> blocks;
    while (void* block = pool.take(100)) blocks.push_back(block);
    QVERIFY(blocks.size() > size / 160);
    std::shuffle(blocks.begin(), blocks.end(), std::mt19937(1));
    for (void* block : blocks) pool.give_back(block);
    QCOMPARE(pool.used(), std::size_t{0});
    QVERIFY(pool.take(size - 64 - size / 16) != nullptr);
  }

  void a_block_that_cannot_grow_stays_as_it_was() {
    LoopPool pool(size);
    auto* block = static_cast<char*>(pool.take(1000));
    std::strcpy(block, "kept");
    QVERIFY(pool.resize(block, 2 * size) == nullptr);
    QCOMPARE(block, "kept");
  }

  void a_block_shrinks_where_it_is() {
    LoopPool pool(size);
    void* block = pool.take(size / 2);
    const std::size_t used = pool.used();
    QCOMPARE(pool.resize(block, 100), block);
    QVERIFY(pool.used() < used / 2);
  }

  void a_long_life_leaves_every_block_sound() {
    LoopPool pool(size);
    Marked marked(pool);
    std::mt19937 random(7);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    for (int i = 0; i < 20'000; ++i) {
      const std::size_t n = 1 + below(below(8) == 0 ? 4000 : 200);
      if (marked.count() == 0 || below(3) == 0)
        marked.take(n);
      else if (below(2) == 0)
        marked.resize(below(marked.count()), n);
      else
        marked.give_back(below(marked.count()));
      if (i % 100 == 0) QVERIFY(marked.sound());
    }
    QVERIFY(marked.sound());
    while (marked.count() > 0) marked.give_back(0);
    QCOMPARE(pool.used(), std::size_t{0});
  }

  void nothing_comes_from_the_heap() {
    LoopPool pool(size);
    const int allocations = trocar::test::allocations_in([&] {
      void* block = pool.resize(pool.take(10), 5000);
      pool.give_back(block);
    });
    QCOMPARE(allocations, 0);
  }
};

QTEST_APPLESS_MAIN(TestLoopPool)
#include "tst_loop_pool.moc"
