// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/workspace.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>

#include "components/devices/seeded_random.hpp"
#include "components/kinematics/laparoscope_gravity.hpp"
#include "components/kinematics/laparoscope_limits.hpp"
#include "components/kinematics/sobol.hpp"
#include "components/requirement.hpp"

namespace trocar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t tips_of_a_piece = 1024;
constexpr std::size_t poses_of_a_piece = 8192;
constexpr std::size_t most_cells = 200'000;
constexpr std::size_t fewest_points = 256;
constexpr std::size_t most_points = std::size_t{1} << 26;  // of all shifts; memory for 1 GB
constexpr std::size_t most_shifts = 1024;

void validate(const WorkspaceSettings& s) {
  validate(s.efforts);
  require(s.shifts >= 2 && s.shifts <= most_shifts, "workspace: shifts",
          static_cast<double>(s.shifts), "needs 2 to 1024 for a standard error, e.g. 16");
  const auto points = [&s](const char* what, std::size_t n, const char* example) {
    const auto value = static_cast<double>(n);
    require(std::has_single_bit(n) && n >= fewest_points, what, value, example);
    require(n <= most_points / s.shifts, what, value,
            "is too many: shifts times this may be 67108864 at most");
  };
  points("workspace: tips", s.tips, "needs a power of 2, at least 256, e.g. 8192");
  points("workspace: poses", s.poses, "needs a power of 2, at least 256, e.g. 65536");
  require(s.gravity.allFinite(), "workspace: gravity", s.gravity.norm(),
          "needs finite numbers in m/s^2");
}

/// Consecutive points under one shift.
struct Piece {
  std::size_t shift, first, count;
};

std::vector<Piece> pieces_of(std::size_t shifts, std::size_t points, std::size_t largest) {
  std::vector<Piece> pieces;
  const std::size_t count = std::min(points, largest);
  for (std::size_t shift = 0; shift < shifts; ++shift)
    for (std::size_t first = 0; first < points; first += count)
      pieces.push_back({shift, first, count});
  return pieces;
}

std::vector<Sobol> shifted(std::size_t count, SeededRandom& random) {
  std::vector<Sobol> sequences;
  for (std::size_t i = 0; i < count; ++i)
    sequences.emplace_back(static_cast<std::uint64_t>(random.uniform(0.0, 0x1p53)));
  return sequences;
}

/// What never changes while points are tried.
class Sampler {
 public:
  explicit Sampler(const WorkspaceSettings& s)
      : s_(s),
        reach_(s.geometry, s.limits),
        bounds_(reach_.bounds()),
        model_(s.geometry),
        weight_(s.geometry, s.masses),
        peak_(s.efforts.peak()),
        continuous_(s.efforts.continuous()) {}

  const LaparoscopeReach::Bounds& bounds() const { return bounds_; }
  bool reaches(const Vector3d& tip) const { return reach_.reaches(tip); }

  /// Of even density in the cylinder.
  Vector3d tip(const Sobol::Point& x) const {
    const double radius = bounds_.radius * std::sqrt(x[0]);
    const double angle = 2.0 * std::numbers::pi * x[1];
    return {radius * std::cos(angle), radius * std::sin(angle),
            std::lerp(bounds_.low, bounds_.high, x[2])};
  }

  std::optional<WorkspacePose> pose(const Sobol::Point& x) const {
    const Vector3d tip = this->tip(x);
    const double cosine = std::lerp(1.0, std::cos(s_.limits.tilt), x[3]);  // even over the sphere
    const double slope = std::sqrt(1.0 - cosine * cosine) / cosine;
    const double angle = 2.0 * std::numbers::pi * x[4];
    const Vector2d slopes(slope * std::cos(angle), slope * std::sin(angle));
    if (!(reach_.margin(tip, slopes) >= 0.0)) return std::nullopt;
    const double theta = std::lerp(-s_.limits.ring_travel, s_.limits.ring_travel, x[5]);
    Vector6d q;
    LaparoscopeConfiguration c;
    if (model_.inverse({tip, std::atan(slopes.x()), std::atan(slopes.y()), theta}, q) !=
            AssemblyStatus::ok ||
        model_.forward(q, c) != AssemblyStatus::ok || !violated_limits(s_.limits, c).empty())
      return std::nullopt;
    const LaparoscopeRates rates = model_.rates(c);
    const Vector6d held = weight_.effort(c, rates, s_.gravity).cwiseAbs();
    return WorkspacePose{tip, slopes, c.tool.engagement,
                         dexterity(rates, s_.geometry.ring_radius, (peak_ - held).cwiseMax(0.0),
                                   (continuous_ - held).cwiseMax(0.0))};
  }

 private:
  const WorkspaceSettings& s_;
  LaparoscopeReach reach_;
  LaparoscopeReach::Bounds bounds_;
  LaparoscopeModel model_;
  LaparoscopeGravity weight_;
  Vector6d peak_, continuous_;
};

struct TriedTip {
  std::uint32_t cell;
  bool reached;
};

std::vector<TriedTip> try_tips(const Sampler& sampler, const CellGrid& grid, Sobol points,
                               const Piece& piece) {
  std::vector<TriedTip> tips;
  points.seek(piece.first);
  for (std::size_t i = 0; i < piece.count; ++i) {
    const Vector3d tip = sampler.tip(points.next());
    tips.push_back({static_cast<std::uint32_t>(grid.index(tip)), sampler.reaches(tip)});
  }
  return tips;
}

std::vector<WorkspacePose> try_poses(const Sampler& sampler, Sobol points, const Piece& piece) {
  std::vector<WorkspacePose> poses;
  points.seek(piece.first);
  for (std::size_t i = 0; i < piece.count; ++i)
    if (const auto pose = sampler.pose(points.next())) poses.push_back(*pose);
  return poses;
}

void estimate_volume(const std::vector<std::size_t>& reached, std::size_t tried, double bounding,
                     Workspace& result) {
  const auto shifts = static_cast<double>(reached.size());
  const auto volume = [&](std::size_t hits) {
    return bounding * static_cast<double>(hits) / static_cast<double>(tried);
  };
  for (const std::size_t hits : reached) result.volume += volume(hits) / shifts;
  double square = 0.0;
  for (const std::size_t hits : reached) square += std::pow(volume(hits) - result.volume, 2);
  result.standard_error = std::sqrt(square / (shifts * (shifts - 1.0)));
}

}  // namespace

std::size_t CellGrid::index(const Vector3d& point) const {
  std::size_t index = 0;
  for (int i = 2; i >= 0; --i) {
    const auto count = counts[static_cast<std::size_t>(i)];
    const double at = std::floor((point[i] - origin[i]) / edge);
    index = index * count +
            static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
  }
  return index;
}

Vector3d CellGrid::centre(std::size_t index) const {
  Vector3d at;
  for (int i = 0; i < 3; ++i) {
    const auto count = counts[static_cast<std::size_t>(i)];
    at[i] = origin[i] + edge * (static_cast<double>(index % count) + 0.5);
    index /= count;
  }
  return at;
}

CellGrid cell_grid(const LaparoscopeReach::Bounds& bounds, double edge) {
  require(edge > 0.0 && std::isfinite(edge), "workspace: cell", edge,
          "needs an edge above 0 m, e.g. 0.020");
  const double half = std::ceil(bounds.radius / edge);
  const double low = std::floor(bounds.low / edge);
  const double layers = std::max(1.0, std::ceil(bounds.high / edge) - low);
  require(4.0 * half * half * layers <= static_cast<double>(most_cells), "workspace: cell", edge,
          "gives more than 200000 cells; widen them, e.g. to 0.020");
  const auto across = static_cast<std::size_t>(2.0 * half);
  return {{-half * edge, -half * edge, low * edge},
          edge,
          {across, across, static_cast<std::size_t>(layers)}};
}

Workspace sample_workspace(const WorkspaceSettings& settings, const ParallelOptions& options) {
  validate(settings);
  const Sampler sampler(settings);
  SeededRandom random(settings.seed);
  const std::vector<Sobol> for_tips = shifted(settings.shifts, random);
  const std::vector<Sobol> for_poses = shifted(settings.shifts, random);
  const std::vector<Piece> tip_pieces = pieces_of(settings.shifts, settings.tips, tips_of_a_piece);
  const std::vector<Piece> pose_pieces =
      pieces_of(settings.shifts, settings.poses, poses_of_a_piece);

  Workspace result;
  result.grid = cell_grid(sampler.bounds(), settings.cell);
  std::vector<std::vector<TriedTip>> tips(tip_pieces.size());
  std::vector<std::vector<WorkspacePose>> poses(pose_pieces.size());
  parallel_for(tips.size() + poses.size(), options, [&](std::size_t i) {
    if (i < tips.size()) {
      tips[i] = try_tips(sampler, result.grid, for_tips[tip_pieces[i].shift], tip_pieces[i]);
    } else {
      const std::size_t j = i - tips.size();
      poses[j] = try_poses(sampler, for_poses[pose_pieces[j].shift], pose_pieces[j]);
    }
  });

  std::vector<std::size_t> reached(settings.shifts, 0);
  result.cells.resize(result.grid.size());
  for (std::size_t i = 0; i < tips.size(); ++i)
    for (const TriedTip& tip : tips[i]) {
      ++result.cells[tip.cell].tried;
      result.cells[tip.cell].reached += tip.reached;
      reached[tip_pieces[i].shift] += tip.reached;
    }
  estimate_volume(reached, settings.tips, sampler.bounds().volume(), result);
  for (const auto& some : poses) result.poses.insert(result.poses.end(), some.begin(), some.end());
  result.poses_tried = settings.shifts * settings.poses;
  return result;
}

}  // namespace trocar
