// SPDX-License-Identifier: Apache-2.0
// Samples and their extremes, also after the oldest went.
#include "gui/data/column.hpp"

#include <QTest>
#include <cmath>
#include <random>

using namespace trocar::gui;

namespace {

Extremes by_looking_at_each(const Column& column, std::uint64_t from, std::uint64_t to) {
  Extremes extremes;
  for (std::uint64_t n = std::max(from, column.first()); n < std::min(to, column.end()); ++n)
    extremes.add(column[n]);
  return extremes;
}

double sample(std::uint64_t n) {
  return 1000.0 * std::sin(0.37 * static_cast<double>(n)) + static_cast<double>(n % 977);
}

}  // namespace

class TestColumn : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_newest_are_kept() {
    Column column(10'000);
    QCOMPARE(column.capacity(), std::size_t{12'288});
    constexpr std::uint64_t count = 100'000;
    for (std::uint64_t n = 0; n < count; ++n) column.add(sample(n));
    QCOMPARE(column.end(), count);
    QVERIFY(column.first() >= count - column.capacity());
    QVERIFY(column.first() <= count - column.capacity() + Column::block);
    for (std::uint64_t n = column.first(); n < count; ++n) QCOMPARE(column[n], sample(n));
  }

  void pieces_of_any_range_are_its_samples() {
    Column column(2 * Column::block);
    for (int i = 0; i < 11'000; ++i) column.add(i);
    for (const auto& [from, to] : std::vector<std::pair<std::uint64_t, std::uint64_t>>{
             {5000, 6000}, {8000, 9000}, {4096, 11'000}, {0, 20'000}, {9000, 9000}, {0, 10}}) {
      std::vector<double> samples, expected;
      for (const auto piece : column.pieces(from, to))
        samples.insert(samples.end(), piece.begin(), piece.end());
      for (std::uint64_t n = std::max(from, column.first()); n < std::min(to, column.end()); ++n)
        expected.push_back(column[n]);
      QCOMPARE(samples, expected);
    }
  }

  void extremes_of_any_range_are_those_of_its_samples() {
    Column column(9'000);
    std::mt19937 random(7);
    for (std::uint64_t n = 0; n < 40'000; ++n) {
      column.add(sample(n));
      if (n % 97 != 0) continue;
      const auto pick = [&] { return random() % (n + 20); };
      const std::uint64_t from = pick(), to = from + pick() % 9'000;
      const Extremes found = column.extremes(from, to), all = by_looking_at_each(column, from, to);
      QCOMPARE(found.min, all.min);
      QCOMPARE(found.max, all.max);
    }
  }

  void one_sample_among_a_million_is_seen() {
    Column column(1'000'000);
    for (int n = 0; n < 1'000'000; ++n) column.add(n == 654'321 ? 5.0 : 0.0);
    QCOMPARE(column.extremes(0, 1'000'000).max, 5.0);
    QCOMPARE(column.extremes(654'321, 654'322).max, 5.0);
    QCOMPARE(column.extremes(654'322, 1'000'000).max, 0.0);
  }

  void what_is_not_a_number_does_not_count() {
    Column column(10);
    for (const double value : {1.0, std::nan(""), 3.0, 2.0}) column.add(value);
    QCOMPARE(column.extremes(0, 4).min, 1.0);
    QCOMPARE(column.extremes(0, 4).max, 3.0);
    QVERIFY(column.extremes(1, 2).empty());
    QVERIFY(column.extremes(3, 3).empty());
  }
};

QTEST_APPLESS_MAIN(TestColumn)
#include "tst_column.moc"
