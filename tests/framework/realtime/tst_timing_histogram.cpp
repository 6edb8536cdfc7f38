// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/timing_histogram.hpp"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using trocar::TimingHistogram;

namespace {

std::vector<std::int64_t> spread_over(double decades, std::size_t count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(0.0, decades);
  std::vector<std::int64_t> samples(count);
  for (std::int64_t& sample : samples)
    sample = static_cast<std::int64_t>(std::pow(10.0, exponent(random)));
  return samples;
}

}  // namespace

class TestTimingHistogram : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void an_empty_one_is_all_zero() {
    const TimingHistogram none;
    QCOMPARE(none.count(), std::uint64_t{0});
    QCOMPARE(none.max(), std::int64_t{0});
    QCOMPARE(none.mean(), 0.0);
    QCOMPARE(none.percentile(0.5), std::int64_t{0});
  }

  void a_percentile_is_never_low_and_at_most_a_sixteenth_high_data() {
    QTest::addColumn<double>("decades");
    QTest::newRow("exact below 16 ns") << 1.2;
    QTest::newRow("a microsecond") << 3.0;
    QTest::newRow("ten seconds") << 10.0;
    QTest::newRow("all that 63 bits hold") << 18.9;
  }
  void a_percentile_is_never_low_and_at_most_a_sixteenth_high() {
    QFETCH(double, decades);
    std::vector<std::int64_t> samples = spread_over(decades, 20'000);
    TimingHistogram histogram;
    for (const std::int64_t sample : samples) histogram.add(sample);
    std::sort(samples.begin(), samples.end());
    for (const double share : {0.001, 0.01, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0}) {
      const double n = static_cast<double>(samples.size());
      const auto exact =
          static_cast<double>(samples[static_cast<std::size_t>(std::ceil(share * n)) - 1]);
      const auto told = static_cast<double>(histogram.percentile(share));
      QVERIFY2(told >= exact, qPrintable(QString::number(share)));
      QVERIFY2(told <= exact * (1.0 + 1.0 / 16.0), qPrintable(QString::number(share)));
    }
  }

  void maximum_and_mean_are_exact() {
    TimingHistogram histogram;
    for (const std::int64_t sample : {7, 1000, 12'345'678}) histogram.add(sample);
    QCOMPARE(histogram.count(), std::uint64_t{3});
    QCOMPARE(histogram.max(), std::int64_t{12'345'678});
    QCOMPARE(histogram.mean(), (7 + 1000 + 12'345'678) / 3.0);
    QCOMPARE(histogram.percentile(1.0), std::int64_t{12'345'678});
  }

  void nothing_and_less_than_nothing_count_as_zero() {
    TimingHistogram histogram;
    for (const std::int64_t sample :
         {std::int64_t{0}, std::int64_t{-1}, std::numeric_limits<std::int64_t>::min()})
      histogram.add(sample);
    QCOMPARE(histogram.count(), std::uint64_t{3});
    QCOMPARE(histogram.max(), std::int64_t{0});
    QCOMPARE(histogram.mean(), 0.0);
    QCOMPARE(histogram.percentile(1.0), std::int64_t{0});
  }

  void its_bins_hold_every_sample_once() {
    const std::vector<std::int64_t> samples = spread_over(10.0, 5'000);
    TimingHistogram histogram;
    for (const std::int64_t sample : samples) histogram.add(sample);
    std::int64_t before = -1;
    std::uint64_t count = 0;
    for (const TimingHistogram::Bin& bin : histogram.bins()) {
      QVERIFY(bin.lower > before && bin.upper >= bin.lower);
      const auto inside = std::count_if(samples.begin(), samples.end(), [&](std::int64_t sample) {
        return sample >= bin.lower && sample <= bin.upper;
      });
      QCOMPARE(bin.count, static_cast<std::uint64_t>(inside));
      before = bin.upper;
      count += bin.count;
    }
    QCOMPARE(count, histogram.count());
    QVERIFY(TimingHistogram().bins().empty());
  }

  void several_make_one() {
    TimingHistogram first, second, both;
    for (const std::int64_t sample : spread_over(8.0, 1'000)) {
      first.add(sample);
      both.add(sample);
    }
    second.add(123'456'789'012);
    both.add(123'456'789'012);
    first.add(second);
    QCOMPARE(first.count(), both.count());
    QCOMPARE(first.max(), both.max());
    QCOMPARE(first.mean(), both.mean());
    for (const double share : {0.1, 0.5, 0.99, 1.0})
      QCOMPARE(first.percentile(share), both.percentile(share));
  }

  void the_longest_duration_fits() {
    TimingHistogram histogram;
    histogram.add(std::numeric_limits<std::int64_t>::max());
    QCOMPARE(histogram.percentile(0.5), std::numeric_limits<std::int64_t>::max());
  }
};

QTEST_APPLESS_MAIN(TestTimingHistogram)
#include "tst_timing_histogram.moc"
