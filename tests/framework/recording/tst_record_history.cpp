// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/record_history.hpp"

#include <QTest>
#include <algorithm>
#include <stdexcept>

#include "tests/support/allocation_counter.hpp"

using trocar::RecordHistory;

namespace {

/// A record's size, tag and bytes follow from its number.
std::vector<std::byte> record_of(std::uint64_t number) {
  return std::vector<std::byte>(1 + number * 37 % 60, static_cast<std::byte>(number));
}
std::uint32_t tag_of(std::uint64_t number) {
  return static_cast<std::uint32_t>(number % 7);
}
void push(RecordHistory& history, std::uint64_t number) {
  history.push(tag_of(number), record_of(number));
}

/// The numbers of the records that are handed out; -1 for one that is not as it was pushed.
std::vector<int> numbers(const RecordHistory& history, std::uint64_t from = 0) {
  std::vector<int> all;
  std::uint64_t number = std::max(from, history.pushed() - history.kept());
  history.for_each(from, [&](std::uint32_t tag, std::span<const std::byte> bytes) {
    const std::vector<std::byte> expected = record_of(number);
    const bool same = tag == tag_of(number) &&
                      std::equal(bytes.begin(), bytes.end(), expected.begin(), expected.end());
    all.push_back(same ? static_cast<int>(number) : -1);
    ++number;
  });
  return all;
}

}  // namespace

class TestRecordHistory : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_new_one_is_empty() { QVERIFY(numbers(RecordHistory(1000)).empty()); }

  void what_fits_is_kept_in_order() {
    RecordHistory history(1000);
    for (std::uint64_t number = 0; number < 10; ++number) push(history, number);
    QCOMPARE(numbers(history), (std::vector{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
    QCOMPARE(numbers(history, 7), (std::vector{7, 8, 9}));
    QVERIFY(numbers(history, 10).empty());
  }

  void the_oldest_go_when_room_is_needed_wherever_the_memory_ends() {
    for (const std::size_t capacity : {144u, 152u, 200u, 256u, 1000u, 1001u}) {
      RecordHistory history(capacity);
      for (std::uint64_t number = 0; number < 2000; ++number) {
        push(history, number);
        const std::vector<int> kept = numbers(history);
        QVERIFY(!kept.empty());
        QCOMPARE(kept.back(), static_cast<int>(number));
        QCOMPARE(kept.front(), static_cast<int>(number + 1 - kept.size()));
        QVERIFY(std::find(kept.begin(), kept.end(), -1) == kept.end());
      }
    }
  }

  void as_many_equal_records_are_kept_as_it_was_made_for() {
    const std::vector<std::byte> row(100);
    RecordHistory history(50 * RecordHistory::taken_by(row.size()));
    for (int i = 0; i < 1000; ++i) history.push(0, row);
    QCOMPARE(history.kept(), std::uint64_t{50});
    QCOMPARE(history.pushed(), std::uint64_t{1000});
  }

  void a_record_that_is_too_large_is_refused() {
    RecordHistory history(100);
    QVERIFY_THROWS_EXCEPTION(std::length_error, history.push(0, std::vector<std::byte>(60)));
  }

  void pushing_allocates_nothing() {
    RecordHistory history(1000);
    const std::vector<std::byte> row(100);
    QCOMPARE(trocar::test::allocations_in([&] {
               for (int i = 0; i < 1000; ++i) history.push(0, row);
             }),
             0);
  }
};

QTEST_APPLESS_MAIN(TestRecordHistory)
#include "tst_record_history.moc"
