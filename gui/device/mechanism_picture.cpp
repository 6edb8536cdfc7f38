// SPDX-License-Identifier: Apache-2.0
#include "gui/device/mechanism_picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trocar::gui {
namespace {

using Eigen::Vector3d;
using Part = MechanismPicture::Part;

constexpr double rail_overhang = 0.015;  // [m]
constexpr double wall_half = 0.045;      // [m] of the piece of a wall that is drawn

Vector3d on_circle(double radius, double angle, double height) {
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

double phase(int i) {
  return 2.0 * std::numbers::pi * i / 3.0;
}

void add_path(MechanismPicture& picture, const std::vector<Vector3d>& points, Part part) {
  for (std::size_t i = 1; i < points.size(); ++i)
    picture.lines.push_back({points[i - 1], points[i], part});
}

void add_circle(MechanismPicture& picture, double radius, double height, Part part) {
  std::vector<Vector3d> points;
  for (int i = 0; i <= 48; ++i)
    points.push_back(on_circle(radius, 2.0 * std::numbers::pi * i / 48.0, height));
  add_path(picture, points, part);
}

/// Two unit vectors across `axis`.
std::pair<Vector3d, Vector3d> across(const Vector3d& axis) {
  const Vector3d u = axis.cross(std::abs(axis.x()) < 0.7 ? Vector3d::UnitX() : Vector3d::UnitY());
  return {u.normalized(), axis.cross(u.normalized())};
}

void add_arrow(MechanismPicture& picture, const Vector3d& from, const Vector3d& to, Part part) {
  picture.lines.push_back({from, to, part});
  const double length = (to - from).norm();
  if (!(length > 1e-6)) return;
  const Vector3d axis = (to - from) / length;
  const double head = std::min(0.3 * length, 0.012);
  const auto [u, v] = across(axis);
  for (const Vector3d& side : {Vector3d(u), Vector3d(-u), Vector3d(v), Vector3d(-v)})
    picture.lines.push_back({to, to - head * axis + 0.45 * head * side, part});
}

void add_frame(MechanismPicture& picture, const LaparoscopeSetup& setup) {
  const LaparoscopeGeometry& g = setup.geometry;
  const double low = setup.limits.slider_low - rail_overhang;
  const double high = setup.limits.slider_high + rail_overhang;
  add_circle(picture, g.base_radius, low, Part::base);
  for (int i = 0; i < 3; ++i)
    picture.lines.push_back({on_circle(g.base_radius, phase(i), low),
                             on_circle(g.base_radius, phase(i), high), Part::rail});
  add_circle(picture, g.ring_radius, g.ring_plane, Part::ring);
}

void add_delta(MechanismPicture& picture, const LaparoscopeSetup& setup,
               const LaparoscopeConfiguration& c) {
  const LaparoscopeGeometry& g = setup.geometry;
  Vector3d corner[3];
  for (int i = 0; i < 3; ++i) {
    const Vector3d slider = on_circle(g.base_radius, phase(i), c.q[i]);
    corner[i] = c.delta.platform + on_circle(g.platform_radius, phase(i), 0.0);
    picture.dots.push_back({slider, Part::carriage});
    picture.labels.push_back({slider, QString::number(i + 1), Part::carriage});
    picture.lines.push_back({slider, corner[i], Part::rod});
  }
  for (int i = 0; i < 3; ++i)
    picture.lines.push_back({corner[i], corner[(i + 1) % 3], Part::platform});
  for (const Vector3d& at : corner) picture.lines.push_back({at, c.delta.platform, Part::platform});
}

void add_rings(MechanismPicture& picture, const LaparoscopeConfiguration& c, double height) {
  const Vector3d gimbal = c.tool.gimbal;
  for (int i = 0; i < 3; ++i) {
    const Vector3d pin(c.rings.pins(0, i), c.rings.pins(1, i), height);
    picture.lines.push_back({gimbal, pin, Part::spoke});
    picture.dots.push_back({pin, Part::ring});
    picture.labels.push_back({pin, QString::number(i + 4), Part::ring});
  }
  picture.dots.push_back({gimbal, Part::gimbal});
}

/// Sites that lie together have one label.
void add_sites(MechanismPicture& picture, const Scene& scene, const MechanismPose& pose) {
  std::vector<std::pair<Vector3d, QString>> marks;
  for (std::size_t i = 0; i < pose.sites.size(); ++i) {
    if (!pose.sites[i]) continue;
    const QString name = QString::fromStdString(scene.sites[i].name);
    const auto near = std::find_if(marks.begin(), marks.end(), [&](const auto& mark) {
      return (mark.first - *pose.sites[i]).norm() < 0.001;
    });
    if (near != marks.end())
      near->second += ", " + name;
    else
      marks.emplace_back(*pose.sites[i], name);
  }
  const Part part = pose.assembled ? Part::site : Part::point;
  for (const auto& [at, text] : marks) {
    picture.dots.push_back({at, part});
    picture.labels.push_back({at, text, part});
  }
}

void add_wall(MechanismPicture& picture, const Scene::Fixture& wall,
              const MechanismPose::Fixture& touched) {
  const Vector3d surface = wall.point + touched.offset * wall.normal;
  Vector3d middle = surface;  // the piece of the wall that is nearest to what touches it
  if (touched.at) middle = *touched.at - (*touched.at - surface).dot(wall.normal) * wall.normal;
  const auto [u, v] = across(wall.normal);
  const auto corner = [&, a = u, b = v](double x, double y) -> Vector3d {
    return middle + wall_half * (x * a + y * b);
  };
  picture.sheets.push_back(
      {{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}, Part::wall});
  add_path(picture, {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)},
           Part::wall);
  for (const double at : {-0.5, 0.0, 0.5}) {
    picture.lines.push_back({corner(at, -1), corner(at, 1), Part::wall});
    picture.lines.push_back({corner(-1, at), corner(1, at), Part::wall});
  }
  add_arrow(picture, corner(1, 1), corner(1, 1) + 0.015 * wall.normal, Part::wall);
  picture.labels.push_back({corner(1, -1), QString::fromStdString(wall.name), Part::wall});
}

/// A zigzag from its centre to what it holds.
void add_spring(MechanismPicture& picture, const Scene::Fixture& spring,
                const MechanismPose::Fixture& touched) {
  if (!touched.centre || !touched.at) return;
  const Vector3d way = *touched.at - *touched.centre;
  picture.dots.push_back({*touched.centre, Part::spring});
  picture.labels.push_back({*touched.centre, QString::fromStdString(spring.name), Part::spring});
  if (!(way.norm() > 1e-4)) return;
  const Vector3d side = across(way.normalized()).first;
  std::vector<Vector3d> points = {*touched.centre};
  for (int i = 1; i < 12; ++i)
    points.push_back(*touched.centre + way * (i / 12.0) + (i % 2 == 0 ? 0.003 : -0.003) * side);
  points.push_back(*touched.at);
  add_path(picture, points, Part::spring);
}

void add_force(MechanismPicture& picture, const Vector3d& at, const Vector3d& force,
               const QString& what) {
  if (!(force.norm() >= 0.05)) return;
  const Vector3d end = at + MechanismPicture::force_scale * force;
  add_arrow(picture, at, end, Part::force);
  picture.labels.push_back({end, what + QString("%1 N").arg(force.norm(), 0, 'f', 1), Part::force});
}

void add_fixtures(MechanismPicture& picture, const Scene& scene, const MechanismPose& pose) {
  for (const MechanismPose::Fixture& touched : pose.fixtures) {
    const Scene::Fixture& fixture = scene.fixtures[touched.index];
    if (fixture.kind == Scene::Fixture::Kind::wall) add_wall(picture, fixture, touched);
    if (fixture.kind == Scene::Fixture::Kind::spring) add_spring(picture, fixture, touched);
    if (!pose.assembled && touched.at && touched.force)
      add_force(picture, *touched.at, *touched.force, QString::fromStdString(fixture.name) + " ");
  }
  if (pose.assembled && pose.force) add_force(picture, pose.mechanism.tool.tip, *pose.force, "");
}

}  // namespace

MechanismPicture MechanismPicture::of(const Scene& scene, const MechanismPose& pose,
                                      const WorkspaceOutline* workspace) {
  MechanismPicture picture;
  if (scene.laparoscope) add_frame(picture, *scene.laparoscope);
  if (workspace != nullptr)
    for (const std::vector<Vector3d>& path : workspace->paths())
      add_path(picture, path, Part::workspace);
  add_fixtures(picture, scene, pose);
  if (pose.assembled) {
    const LaparoscopeConfiguration& c = pose.mechanism;
    add_delta(picture, *scene.laparoscope, c);
    add_rings(picture, c, scene.laparoscope->geometry.ring_plane);
    picture.lines.push_back({c.tool.ball, c.tool.tip, Part::tool});
    picture.dots.push_back({c.tool.ball, Part::platform});
  }
  add_sites(picture, scene, pose);
  return picture;
}

std::vector<Vector3d> MechanismPicture::extent(const Scene& scene, const MechanismPose& pose) {
  std::vector<Vector3d> points;
  if (scene.laparoscope) {
    const LaparoscopeGeometry& g = scene.laparoscope->geometry;
    const double low = scene.laparoscope->limits.slider_low - rail_overhang;
    for (int i = 0; i < 12; ++i) {
      const double angle = std::numbers::pi * i / 6.0;
      points.push_back(on_circle(g.base_radius, angle, low));
      points.push_back(on_circle(g.ring_radius, angle, g.ring_plane));
      points.push_back(on_circle(0.5 * g.ring_radius, angle, g.ring_plane + 0.9 * g.tool_length));
    }
    return points;
  }
  // Round about the origin, in steps, so that small motions leave it as it is.
  double reach = 0.05;
  for (const auto& site : pose.sites)
    if (site) reach = std::max(reach, site->norm());
  for (const MechanismPose::Fixture& one : pose.fixtures)
    if (one.at) reach = std::max(reach, one.at->norm());
  reach = 0.05 * std::ceil(1.2 * reach / 0.05);
  for (const double x : {-reach, reach})
    for (const double y : {-reach, reach})
      for (const double z : {-reach, reach}) points.emplace_back(x, y, z);
  return points;
}

}  // namespace trocar::gui
