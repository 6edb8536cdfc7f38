// SPDX-License-Identifier: Apache-2.0
#include "framework/types.hpp"

#include <fmt/format.h>

namespace trocar {

static_assert(std::is_trivially_copyable_v<Pose> && std::is_trivially_copyable_v<Wrench> &&
              std::is_trivially_copyable_v<Joints> && std::is_trivially_copyable_v<Jacobian> &&
              std::is_trivially_copyable_v<PointMotion> && std::is_trivially_copyable_v<Twist>);
static_assert(sizeof(Vector3) == 24 && sizeof(Pose) == 56 && sizeof(Jacobian) == 384);

namespace {

TypeInfo leaf(const char* name, std::size_t size, Scalar scalar) {
  return {.name = name, .size = size, .scalar = scalar, .units = {""}};
}

TypeInfo pair(const char* name, const char* first, const TypeInfo& a, const char* second,
              const TypeInfo& b, std::vector<std::string> units) {
  return {.name = name,
          .size = a.size + b.size,
          .fields = {{first, &a, 0, 0}, {second, &b, a.size, 1}},
          .units = std::move(units)};
}

TypeInfo reals(const char* name, const std::vector<std::string>& names) {
  TypeInfo info{.name = name, .size = 8 * names.size(), .units = {""}};
  for (const std::string& field : names)
    info.fields.push_back({field, &type_info<double>(), 8 * info.fields.size(), 0});
  return info;
}

TypeInfo joints() {
  TypeInfo info{.name = "Joints", .size = sizeof(Joints), .per_axis = 1};
  for (std::size_t i = 0; i < max_axes; ++i)
    info.fields.push_back({fmt::format("axis{}", i + 1), &type_info<double>(), 8 * i, i});
  return info;
}

TypeInfo jacobian() {
  TypeInfo info{.name = "Jacobian", .size = sizeof(Jacobian), .units = {""}, .per_axis = 6};
  for (std::size_t i = 0; i < 6 * max_axes; ++i)
    info.fields.push_back(
        {fmt::format("j{}{}", i % 6 + 1, i / 6 + 1), &type_info<double>(), 8 * i, 0});
  return info;
}

}  // namespace

template <>
const TypeInfo& type_info<double>() {
  static const TypeInfo info = leaf("double", 8, Scalar::real);
  return info;
}
template <>
const TypeInfo& type_info<std::int64_t>() {
  static const TypeInfo info = leaf("int64", 8, Scalar::integer);
  return info;
}
template <>
const TypeInfo& type_info<bool>() {
  static const TypeInfo info = leaf("bool", 1, Scalar::boolean);
  return info;
}
template <>
const TypeInfo& type_info<Enumeration>() {
  static const TypeInfo info = leaf("Enumeration", 8, Scalar::integer);
  return info;
}
template <>
const TypeInfo& type_info<Vector3>() {
  static const TypeInfo info = reals("Vector3", {"x", "y", "z"});
  return info;
}
template <>
const TypeInfo& type_info<Rotation>() {
  static const TypeInfo info = reals("Rotation", {"x", "y", "z", "w"});
  return info;
}
template <>
const TypeInfo& type_info<Pose>() {
  static const TypeInfo info =
      pair("Pose", "position", type_info<Vector3>(), "rotation", type_info<Rotation>(), {"m", ""});
  return info;
}
template <>
const TypeInfo& type_info<PointMotion>() {
  static const TypeInfo info = pair("PointMotion", "position", type_info<Vector3>(), "velocity",
                                    type_info<Vector3>(), {"m", "m/s"});
  return info;
}
template <>
const TypeInfo& type_info<Twist>() {
  static const TypeInfo info = pair("Twist", "linear", type_info<Vector3>(), "angular",
                                    type_info<Vector3>(), {"m/s", "rad/s"});
  return info;
}
template <>
const TypeInfo& type_info<Wrench>() {
  static const TypeInfo info =
      pair("Wrench", "force", type_info<Vector3>(), "moment", type_info<Vector3>(), {"N", "N m"});
  return info;
}
template <>
const TypeInfo& type_info<Joints>() {
  static const TypeInfo info = joints();
  return info;
}
template <>
const TypeInfo& type_info<Jacobian>() {
  static const TypeInfo info = jacobian();
  return info;
}

const std::vector<const TypeInfo*>& port_types() {
  static const std::vector<const TypeInfo*> all = {
      &type_info<double>(),      &type_info<std::int64_t>(), &type_info<bool>(),
      &type_info<Enumeration>(), &type_info<Vector3>(),      &type_info<Rotation>(),
      &type_info<Pose>(),        &type_info<PointMotion>(),  &type_info<Twist>(),
      &type_info<Wrench>(),      &type_info<Joints>(),       &type_info<Jacobian>()};
  return all;
}

std::size_t field_count(const TypeInfo& type, int axes) {
  return type.per_axis == 0 ? type.fields.size() : type.per_axis * static_cast<std::size_t>(axes);
}

}  // namespace trocar
