// SPDX-License-Identifier: Apache-2.0
// The figures of the default geometry, as docs/mathematics.md states them, and how they are made.
#include "components/kinematics/workspace.hpp"

#include <QTest>
#include <cmath>
#include <cstring>
#include <numbers>

#include "components/kinematics/laparoscope_gravity.hpp"
#include "components/kinematics/laparoscope_limits.hpp"
#include "components/kinematics/workspace_map.hpp"
#include "components/kinematics/workspace_ranges.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double cm3 = 1e-6;  // [m^3]

WorkspaceSettings quick() {
  return {.shifts = 4, .tips = 1024, .poses = 8192};
}

/// All numbers of the result, one after the other.
std::vector<double> numbers_of(const Workspace& w) {
  std::vector<double> all = {w.volume, w.standard_error};
  for (const Workspace::Tips& tips : w.cells)
    all.insert(all.end(), {1.0 * tips.tried, 1.0 * tips.reached});
  for (const WorkspacePose& p : w.poses) {
    const Dexterity& d = p.dexterity;
    all.insert(all.end(),
               {p.tip.x(), p.tip.y(), p.tip.z(), p.slopes.x(), p.slopes.y(), p.engagement,
                d.condition, d.manipulability, d.peak_force, d.continuous_force});
  }
  return all;
}

bool same_bytes(const Workspace& a, const Workspace& b) {
  const std::vector<double> x = numbers_of(a), y = numbers_of(b);
  return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

}  // namespace

class TestWorkspace : public QObject {
  Q_OBJECT

  const Workspace default_ = sample_workspace({});

 private Q_SLOTS:
  void the_volume_is_the_known_one() {
    QVERIFY2(std::abs(default_.volume - 3508 * cm3) < 6 * cm3,
             qPrintable(QString::number(default_.volume / cm3)));
    QVERIFY(default_.standard_error < 0.01 * default_.volume);
    // A grid of 37 rings of slopes finds 0.4 % less, on the same tips as a finer one.
    QVERIFY(std::abs(default_.volume - 3467 * cm3) < 2.5 * 21 * cm3);
  }

  // Each estimate should lie within two or three of its own errors of what all of them agree on.
  void the_standard_error_is_honest() {
    double square = 0.0;
    constexpr int runs = 20;
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
      const Workspace w = sample_workspace({.seed = seed, .shifts = 16, .tips = 512, .poses = 256});
      square += std::pow((w.volume - default_.volume) / w.standard_error, 2) / runs;
    }
    QVERIFY2(square > 0.4 && square < 2.5, qPrintable(QString::number(square)));
  }

  void the_same_seed_gives_the_same_bytes_data() {
    QTest::addColumn<unsigned>("threads");
    QTest::newRow("two threads") << 2u;
    QTest::newRow("three threads") << 3u;
    QTest::newRow("one for each processor") << 0u;
  }
  void the_same_seed_gives_the_same_bytes() {
    QFETCH(unsigned, threads);
    const Workspace alone = sample_workspace(quick(), {.threads = 1});
    QVERIFY(same_bytes(alone, sample_workspace(quick(), {.threads = threads})));
  }

  void another_seed_gives_other_points() {
    WorkspaceSettings other = quick();
    other.seed = 2;
    QVERIFY(!same_bytes(sample_workspace(quick()), sample_workspace(other)));
  }

  void each_pose_is_inside_all_limits() {
    const LaparoscopeModel model;
    for (const WorkspacePose& pose : sample_workspace(quick()).poses)
      QVERIFY(reachable(model, {},
                        {pose.tip, std::atan(pose.slopes.x()), std::atan(pose.slopes.y()), 0.0}));
  }

  void the_extent_is_the_known_one() {
    const WorkspaceExtent e = workspace_extent({}, default_.poses);
    const auto near = [](double value, double expected, double tolerance) {
      return std::abs(value - expected) <= tolerance;
    };
    for (const double one : {-e.x.low, e.x.high, -e.y.low, e.y.high})
      QVERIFY2(near(one, 0.127, 0.005), qPrintable(QString::number(one)));
    QVERIFY(near(e.y.low, -e.y.high, 5e-4));  // the device is its own mirror image
    QVERIFY(near(e.z.low, 0.024, 0.001) && near(e.z.high, 0.143, 0.002));
    for (const double one : {-e.yaw.low, e.yaw.high, -e.pitch.low, e.pitch.high})
      QVERIFY(near(one, 44.95 * degree, 0.051 * degree));
  }

  void insertion_at_a_translation_is_the_known_one_data() {
    QTest::addColumn<double>("translation");  // [mm]
    QTest::addColumn<double>("range");        // [mm], found on steps of 0.5 mm
    QTest::newRow("on the axis") << 0.0 << 119.5;
    QTest::newRow("20 mm") << 20.0 << 97.5;
    QTest::newRow("40 mm") << 40.0 << 75.0;
    QTest::newRow("50 mm") << 50.0 << 62.5;
    QTest::newRow("at the end of the translation") << 59.9 << 49.5;
  }
  void insertion_at_a_translation_is_the_known_one() {
    QFETCH(double, translation);
    QFETCH(double, range);
    const double found = insertion_range({}, {}, translation * 1e-3) * 1e3;
    QVERIFY2(found >= range && found < range + 1.0, qPrintable(QString::number(found)));
  }

  // Against poses that are asked one by one, in 24 directions, every 0.1 mm.
  void insertion_is_what_the_poses_say() {
    const LaparoscopeModel model;
    for (const double translation : {0.0, 0.015, 0.033, 0.0599}) {
      int common = 0;
      for (int i = 0; i < 1300; ++i) {
        const double z = 0.02 + 1e-4 * i;
        bool everywhere = true;
        for (int j = 0; j < 24 && everywhere; ++j) {
          const double angle = 15.0 * degree * j;
          everywhere = reachable(
              model, {},
              {{translation * std::cos(angle), translation * std::sin(angle), z}, 0.0, 0.0, 0.0});
        }
        common += everywhere;
      }
      QVERIFY(std::abs(1e-4 * common - insertion_range({}, {}, translation)) < 3e-4);
    }
  }

  void beyond_its_limits_there_is_no_insertion() {
    QCOMPARE(insertion_range({}, {}, 0.061), 0.0);
    QCOMPARE(insertion_range({}, {.link_angle = 30.0 * degree}, 0.01), 0.0);
  }

  void roll_is_480_degrees_on_the_axis_and_less_beside_it() {
    QVERIFY(std::abs(roll_range({}, {}, 0.0) - 240.0 * degree) < 1e-12);
    QVERIFY(std::abs(roll_range({}, {}, 0.06) - 198.19 * degree) < 0.01 * degree);
  }

  void roll_is_what_the_poses_say() {
    const LaparoscopeModel model;
    double least = 10.0;
    for (int j = 0; j < 360; ++j) {
      const double angle = degree * j;
      double theta = 0.0;
      while (reachable(model, {},
                       {{0.0599 * std::cos(angle), 0.0599 * std::sin(angle), 0.085}, 0, 0, theta}))
        theta += 0.1 * degree;
      least = std::min(least, theta);
    }
    QVERIFY2(std::abs(least - roll_range({}, {}, 0.0599)) < 0.2 * degree,
             qPrintable(QString::number(least / degree)));
  }

  void tilt_in_every_direction_is_the_known_one_data() {
    QTest::addColumn<double>("depth");  // [mm]
    QTest::addColumn<double>("tilt");   // [deg], at least
    QTest::newRow("60 mm") << 60.0 << 44.5;
    QTest::newRow("85 mm") << 85.0 << 44.5;
    QTest::newRow("110 mm") << 110.0 << 40.5;
    QTest::newRow("130 mm") << 130.0 << 26.0;
  }
  void tilt_in_every_direction_is_the_known_one() {
    QFETCH(double, depth);
    QFETCH(double, tilt);
    const double found = tilt_range({}, {}, depth * 1e-3) / degree;
    QVERIFY2(found >= tilt && found < tilt + 0.6, qPrintable(QString::number(found)));
  }

  void where_the_upright_tool_does_not_fit_there_is_no_tilt() {
    QVERIFY(std::isnan(tilt_range({}, {}, 0.0252)));  // the sliders end 0.1 mm before
    QVERIFY(std::isnan(tilt_range({}, {}, 0.1451)));
    QVERIFY(tilt_range({}, {}, 0.145) < 0.1 * degree);
  }

  void conditioning_and_force_are_the_known_ones() {
    for (const EngagementBand& band : by_engagement(default_.poses, {}, 0.02)) {
      const DexteritySpread& d = band.dexterity;
      QVERIFY(d.poses > 100);
      QVERIFY(d.condition.greatest < 29.0);
      if (band.engagement.low > 0.059)
        QVERIFY(d.condition.median > 4.5 && d.condition.median < 10.0);
      if (band.engagement.low > 0.079) QVERIFY(d.peak_force.least > 80.0);
    }
    std::vector<double> peak, continuous;
    double strong = 0.0;
    for (const WorkspacePose& pose : default_.poses) {
      peak.push_back(pose.dexterity.peak_force);
      continuous.push_back(pose.dexterity.continuous_force);
      strong += pose.dexterity.peak_force >= 68.0;
    }
    QVERIFY(std::abs(strong / static_cast<double>(peak.size()) - 0.92) < 0.015);
    QVERIFY(std::abs(spread_of(peak).median - 117.0) < 4.0);
    QVERIFY(std::abs(spread_of(continuous).median - 26.5) < 1.0);
  }

  void weight_takes_its_share_of_the_efforts() {
    WorkspaceSettings heavy = quick();
    heavy.gravity = standard_gravity;
    const Workspace light = sample_workspace(quick()), held = sample_workspace(heavy);
    QCOMPARE(held.poses.size(), light.poses.size());
    for (std::size_t i = 0; i < held.poses.size(); ++i)
      QVERIFY(held.poses[i].dexterity.continuous_force <
              light.poses[i].dexterity.continuous_force + 1e-9);
  }

  void the_map_holds_every_pose_and_the_volume() {
    const std::vector<WorkspaceCell> cells = workspace_map(default_);
    std::size_t poses = 0;
    double volume = 0.0;
    for (const WorkspaceCell& cell : cells) {
      poses += cell.dexterity.poses;
      QVERIFY(cell.filled >= 0.0 && cell.filled <= 1.0);
      volume += cell.filled * std::pow(default_.grid.edge, 3);
    }
    QCOMPARE(poses, default_.poses.size());
    // Cells at the rim reach beyond the cylinder, where nothing was tried.
    QVERIFY(volume > default_.volume && volume < 1.06 * default_.volume);
  }

  void a_point_lies_in_the_cell_about_whose_centre_it_is() {
    const CellGrid grid = cell_grid({.radius = 0.15, .low = 0.0235, .high = 0.15}, 0.02);
    QCOMPARE(grid.size(), std::size_t{16 * 16 * 7});
    for (const std::size_t i : {std::size_t{0}, std::size_t{17}, grid.size() - 1})
      QCOMPARE(grid.index(grid.centre(i)), i);
    QVERIFY((grid.centre(grid.index({0.001, -0.001, 0.03})) - Eigen::Vector3d(0.01, -0.01, 0.03))
                .norm() < 1e-12);
    QCOMPARE(grid.index({9.0, 9.0, 9.0}), grid.size() - 1);
  }

  void a_profile_holds_every_pose() {
    const WorkspaceProfile profile = workspace_profile(default_.poses, 0.02);
    std::size_t poses = 0;
    for (const auto& row : profile.rows) {
      QCOMPARE(row.size(), profile.rows.front().size());
      for (const DexteritySpread& square : row) poses += square.poses;
    }
    QCOMPARE(poses, default_.poses.size());
    QCOMPARE(profile.low, 0.02);
  }

  void spreads_of_few_numbers() {
    QVERIFY(std::isnan(spread_of({}).median));
    QCOMPARE(spread_of({3.0}).median, 3.0);
    QCOMPARE(spread_of({4.0, 1.0}).median, 2.5);
    QCOMPARE(spread_of({3.0, 1.0, 2.0}).greatest, 3.0);
  }

  void a_device_that_reaches_nothing_has_no_volume() {
    WorkspaceSettings settings = quick();
    settings.limits.slider_low = -1.001;
    settings.limits.slider_high = -1.0;
    const Workspace w = sample_workspace(settings);
    QCOMPARE(w.volume, 0.0);
    QVERIFY(w.poses.empty() && workspace_map(w).empty());
    QCOMPARE(workspace_extent(settings, w.poses).x.high, 0.0);
    QVERIFY(workspace_profile(w.poses, 0.02).rows.empty());
  }

  void settings_that_cannot_be_are_refused_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<QString>("message");
    QTest::newRow("one shift has no error") << 0 << "workspace: shifts = 1: needs 2 to 1024";
    QTest::newRow("tips that are no power of 2") << 1 << "workspace: tips = 1000: needs a power";
    QTest::newRow("too few poses") << 2 << "workspace: poses = 128: needs a power of 2, at least";
    QTest::newRow("more poses than memory") << 8 << "workspace: poses = 3.35544e+07: is too many";
    QTest::newRow("a cell without size") << 3 << "workspace: cell = 0: needs an edge above 0 m";
    QTest::newRow("cells too small") << 4 << "workspace: cell = 0.0001: gives more than 200000";
    QTest::newRow("an effort below 0") << 5 << "efforts: ring_peak = -1: needs at least 0 N m";
    QTest::newRow("a geometry") << 6 << "geometry: tool_length = -1";
    QTest::newRow("a mass") << 7 << "masses: tool = -1";
  }
  void settings_that_cannot_be_are_refused() {
    QFETCH(int, which);
    QFETCH(QString, message);
    WorkspaceSettings s = quick();
    if (which == 0) s.shifts = 1;
    if (which == 1) s.tips = 1000;
    if (which == 2) s.poses = 128;
    if (which == 3) s.cell = 0.0;
    if (which == 4) s.cell = 1e-4;
    if (which == 5) s.efforts.ring_peak = -1.0;
    if (which == 6) s.geometry.tool_length = -1.0;
    if (which == 8) s.poses = std::size_t{1} << 25;
    if (which == 7) s.masses.tool = -1.0;
    try {
      sample_workspace(s);
      QFAIL("nothing was refused");
    } catch (const std::invalid_argument& error) {
      QVERIFY2(QString(error.what()).startsWith(message), error.what());
    }
  }
};

QTEST_APPLESS_MAIN(TestWorkspace)
#include "tst_workspace.moc"
