// SPDX-License-Identifier: Apache-2.0
#include "gui/device/mechanism_pose.hpp"

#include <QStringList>
#include <cmath>
#include <numbers>

namespace trocar::gui {
namespace {

QString degrees(double angle) {
  return QString("%1°").arg(angle * 180.0 / std::numbers::pi, 0, 'f', 1);
}

void assemble(const LaparoscopeSetup& setup, const DataStore& data, MechanismPose& pose) {
  Vector6d q;
  for (int i = 0; i < 6; ++i)
    q[i] = newest_number(data, setup.device + ".position.axis" + std::to_string(i + 1));
  if (!q.allFinite()) {
    pose.trouble = "no positions of " + QString::fromStdString(setup.device) + " yet";
    return;
  }
  const LaparoscopeModel model(setup.geometry);
  const AssemblyStatus status = model.forward(q, pose.mechanism);
  pose.assembled = status == AssemblyStatus::ok;
  if (pose.assembled)
    pose.violated = violated_limits(setup.limits, pose.mechanism);
  else
    pose.trouble = "the reported positions do not fit together: " + QString(describe(status));
}

MechanismPose::Fixture touch(const Scene::Fixture& fixture, std::size_t index,
                             const DataStore& data) {
  MechanismPose::Fixture touched;
  touched.index = index;
  touched.at = newest_vector(data, fixture.position);
  touched.force = newest_vector(data, fixture.force);
  touched.depth = newest_number(data, fixture.depth);
  const double offset = newest_number(data, fixture.offset);
  touched.offset = std::isfinite(offset) ? offset : 0.0;
  const auto displacement = newest_vector(data, fixture.displacement);
  if (touched.at && displacement) touched.centre = *touched.at - *displacement;
  return touched;
}

QString text_of_joints(const Vector6d& q) {
  QStringList sliders, rings;
  for (int i = 0; i < 3; ++i) {
    sliders << QString::number(1e3 * q[i], 'f', 1);
    rings << degrees(q[3 + i]);
  }
  return "sliders " + sliders.join(", ") + " mm, rings " + rings.join(", ");
}

QString text_of_fixture(const Scene::Fixture& fixture, const MechanismPose::Fixture& touched) {
  QString text = QString::fromStdString(fixture.name);
  text += touched.force ? QString(" %1 N").arg(touched.force->norm(), 0, 'f', 1) : ": no force yet";
  if (touched.depth > 0.0) text += QString(", %1 mm deep").arg(1e3 * touched.depth, 0, 'f', 1);
  return text;
}

}  // namespace

QString text_of_point(const Eigen::Vector3d& point) {
  return QString("x %1, y %2, z %3 mm")
      .arg(1e3 * point.x(), 0, 'f', 1)
      .arg(1e3 * point.y(), 0, 'f', 1)
      .arg(1e3 * point.z(), 0, 'f', 1);
}

MechanismPose MechanismPose::of(const Scene& scene, const DataStore& data) {
  MechanismPose pose;
  if (scene.laparoscope) assemble(*scene.laparoscope, data, pose);
  if (const auto asked = newest_vector(data, scene.wrench + ".force")) {
    const double scale = newest_number(data, scene.scale);
    pose.force = (std::isfinite(scale) ? scale : 1.0) * *asked;
  }
  for (const Scene::Site& site : scene.sites)
    pose.sites.push_back(newest_vector(data, site.position));
  for (std::size_t i = 0; i < scene.fixtures.size(); ++i)
    pose.fixtures.push_back(touch(scene.fixtures[i], i, data));
  return pose;
}

QString MechanismPose::description(const Scene& scene) const {
  QStringList parts;
  if (!scene.laparoscope) parts << "The graph has no laparoscope";
  if (scene.laparoscope && !assembled) parts << "No picture: " + trouble;
  if (assembled) {
    parts << "Tip at " + text_of_point(mechanism.tool.tip)
          << "tool tilted by " + degrees(mechanism.tool.tilt()) + ", turned by " +
                 degrees(mechanism.tool.theta)
          << text_of_joints(mechanism.q);
    for (unsigned limit = 0; limit < LimitSet::count; ++limit)
      if (violated.has(limit)) parts << QString("beyond the limit ") + LimitSet::name(limit);
  } else {
    for (std::size_t i = 0; i < sites.size(); ++i)
      if (sites[i])
        parts << QString::fromStdString(scene.sites[i].name) + " at " + text_of_point(*sites[i]);
  }
  if (force) parts << QString("force %1 N").arg(force->norm(), 0, 'f', 1);
  for (const Fixture& one : fixtures) parts << text_of_fixture(scene.fixtures[one.index], one);
  return parts.join("; ") + ".";
}

}  // namespace trocar::gui
