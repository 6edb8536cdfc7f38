// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/sobol.hpp"

#include <QTest>
#include <cmath>
#include <set>
#include <vector>

using trocar::Sobol;

namespace {

constexpr std::size_t dimensions = Sobol::most_dimensions;

std::vector<Sobol::Point> first(Sobol sobol, std::size_t count) {
  std::vector<Sobol::Point> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(sobol.next());
  return points;
}

/// Mean of prod (1 + (x_d - 1/2) / d), whose exact value is 1.
double mean_of_products(Sobol sobol, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Sobol::Point x = sobol.next();
    double product = 1.0;
    for (std::size_t d = 0; d < dimensions; ++d)
      product *= 1.0 + (x[d] - 0.5) / static_cast<double>(d + 1);
    sum += product;
  }
  return sum / static_cast<double>(count);
}

}  // namespace

class TestSobol : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // As the program of Joe and Kuo prints them.
  void the_first_points_are_the_published_ones() {
    const double expected[10][3] = {{0, 0, 0},
                                    {0.5, 0.5, 0.5},
                                    {0.75, 0.25, 0.25},
                                    {0.25, 0.75, 0.75},
                                    {0.375, 0.375, 0.625},
                                    {0.875, 0.875, 0.125},
                                    {0.625, 0.125, 0.875},
                                    {0.125, 0.625, 0.375},
                                    {0.1875, 0.3125, 0.9375},
                                    {0.6875, 0.8125, 0.4375}};
    const auto points = first(Sobol(), 10);
    for (std::size_t i = 0; i < 10; ++i)
      for (std::size_t d = 0; d < 3; ++d) QCOMPARE(points[i][d], expected[i][d]);
  }

  void each_dimension_meets_each_interval_once_data() {
    QTest::addColumn<bool>("shifted");
    QTest::newRow("as published") << false;
    QTest::newRow("shifted") << true;
  }
  void each_dimension_meets_each_interval_once() {
    QFETCH(bool, shifted);
    const auto points = first(shifted ? Sobol(7) : Sobol(), 4096);
    for (std::size_t d = 0; d < dimensions; ++d) {
      std::set<int> met;
      for (const Sobol::Point& x : points) met.insert(static_cast<int>(std::floor(x[d] * 4096)));
      QCOMPARE(met.size(), std::size_t{4096});
    }
  }

  // Property A of Sobol: among the first 2^8 points each of the cube's 2^8 halves by halves has
  // one.
  void the_halves_of_all_dimensions_together_are_met_once_data() {
    each_dimension_meets_each_interval_once_data();
  }
  void the_halves_of_all_dimensions_together_are_met_once() {
    QFETCH(bool, shifted);
    std::set<unsigned> met;
    for (const Sobol::Point& x : first(shifted ? Sobol(7) : Sobol(), 256)) {
      unsigned octant = 0;
      for (std::size_t d = 0; d < dimensions; ++d) octant = octant << 1 | (x[d] >= 0.5 ? 1u : 0u);
      met.insert(octant);
    }
    QCOMPARE(met.size(), std::size_t{256});
  }

  void seek_goes_on_where_a_walk_would_be() {
    const auto walked = first(Sobol(3), 1100);
    for (const std::size_t at : {0u, 1u, 2u, 3u, 511u, 512u, 1023u, 1024u}) {
      Sobol sobol(3);
      sobol.seek(at);
      for (std::size_t i = at; i < at + 8; ++i) QVERIFY(sobol.next() == walked[i]);
    }
  }

  void points_stay_below_1() {
    for (const Sobol::Point& x : first(Sobol(11), 4096))
      for (const double one : x) QVERIFY(one >= 0.0 && one < 1.0);
  }

  void a_seed_gives_its_own_points() {
    QVERIFY(first(Sobol(1), 4) == first(Sobol(1), 4));
    QVERIFY(first(Sobol(1), 1) != first(Sobol(2), 1));
  }

  void a_mean_is_far_closer_than_that_of_random_points() {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
      worst = std::max(worst, std::abs(mean_of_products(Sobol(seed), 4096) - 1.0));
    QVERIFY2(worst < 5e-4, qPrintable(QString::number(worst)));  // random ones: 0.37 / 64 = 6e-3
  }
};

QTEST_APPLESS_MAIN(TestSobol)
#include "tst_sobol.moc"
