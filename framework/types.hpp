// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "framework/abi.hpp"

/// @file
/// The values that ports carry. Each is a trivially copyable struct of fixed size with Eigen views
/// (Eigen's own matrices are not trivially copyable), so that a value is copied by memcpy into
/// rows, rings and logs. A composite holds doubles only.

namespace trocar {

constexpr int max_axes = 8;

struct Vector3 {
  double x = 0, y = 0, z = 0;

  Vector3() = default;
  Vector3(double x_, double y_, double z_) : x(x_), y(y_), z(z_) {}
  Vector3(const Eigen::Vector3d& v) : x(v.x()), y(v.y()), z(v.z()) {}  // NOLINT: a view both ways
  Eigen::Map<Eigen::Vector3d> eigen() { return Eigen::Map<Eigen::Vector3d>(&x); }
  Eigen::Map<const Eigen::Vector3d> eigen() const { return Eigen::Map<const Eigen::Vector3d>(&x); }
};

/// A unit quaternion.
struct Rotation {
  double x = 0, y = 0, z = 0, w = 1;

  Rotation() = default;
  explicit Rotation(const Eigen::Quaterniond& q) : x(q.x()), y(q.y()), z(q.z()), w(q.w()) {}
  Eigen::Map<const Eigen::Quaterniond> eigen() const {
    return Eigen::Map<const Eigen::Quaterniond>(&x);
  }
};

struct Pose {
  Vector3 position;
  Rotation rotation;
};

/// Velocity and position of one point of a tool: what a fixture placed there needs.
struct PointMotion {
  Vector3 position;
  Vector3 velocity;
};

using Vector6 = Eigen::Matrix<double, 6, 1>;

struct Twist {
  Vector3 linear;
  Vector3 angular;
  Eigen::Map<Vector6> eigen() { return Eigen::Map<Vector6>(&linear.x); }
  Eigen::Map<const Vector6> eigen() const { return Eigen::Map<const Vector6>(&linear.x); }
};

struct Wrench {
  Vector3 force;
  Vector3 moment;
  Eigen::Map<Vector6> eigen() { return Eigen::Map<Vector6>(&force.x); }
  Eigen::Map<const Vector6> eigen() const { return Eigen::Map<const Vector6>(&force.x); }
};

/// One number for each axis of a device. How many axes count is the port's, not the value's, so
/// that it cannot change while the loop runs; the rest stays 0.
struct Joints {
  double axis[max_axes] = {};

  double& operator[](int i) { return axis[i]; }
  double operator[](int i) const { return axis[i]; }
  template <int N>
  Eigen::Map<Eigen::Matrix<double, N, 1>> head() {
    static_assert(N <= max_axes);
    return Eigen::Map<Eigen::Matrix<double, N, 1>>(axis);
  }
  template <int N>
  Eigen::Map<const Eigen::Matrix<double, N, 1>> head() const {
    static_assert(N <= max_axes);
    return Eigen::Map<const Eigen::Matrix<double, N, 1>>(axis);
  }
};

/// Twist = J axis velocities: 6 × axes, column by column, so that fewer axes are a prefix.
struct Jacobian {
  double column[max_axes][6] = {};

  template <int N>
  Eigen::Map<Eigen::Matrix<double, 6, N>> head() {
    return Eigen::Map<Eigen::Matrix<double, 6, N>>(&column[0][0]);
  }
  template <int N>
  Eigen::Map<const Eigen::Matrix<double, 6, N>> head() const {
    return Eigen::Map<const Eigen::Matrix<double, 6, N>>(&column[0][0]);
  }
};

/// An index into the labels that its port declares.
struct Enumeration {
  std::int64_t index = 0;
};

enum class Scalar { real, integer, boolean };

struct TypeInfo;

/// A named part of a composite type.
struct TypeField {
  std::string name;
  const TypeInfo* type = nullptr;
  std::size_t offset = 0;  // [bytes]
  std::size_t block = 0;   // which of the type's units it has
};

/// What the framework knows of a port type; one object for each, compared by address.
struct TypeInfo {
  std::string name;
  std::size_t size = 0;              // [bytes]
  Scalar scalar = Scalar::real;      // of a leaf
  std::vector<TypeField> fields{};   // empty for a leaf
  std::vector<std::string> units{};  // usual unit of each block, "" where the port must say
  std::size_t per_axis = 0;          // fields for each axis: 1 Joints, 6 Jacobian, 0 the others
};

template <typename T>
const TypeInfo& type_info();

template <>
const TypeInfo& type_info<double>();
template <>
const TypeInfo& type_info<std::int64_t>();
template <>
const TypeInfo& type_info<bool>();
template <>
const TypeInfo& type_info<Enumeration>();
template <>
const TypeInfo& type_info<Vector3>();
template <>
const TypeInfo& type_info<Rotation>();
template <>
const TypeInfo& type_info<Pose>();
template <>
const TypeInfo& type_info<PointMotion>();
template <>
const TypeInfo& type_info<Twist>();
template <>
const TypeInfo& type_info<Wrench>();
template <>
const TypeInfo& type_info<Joints>();
template <>
const TypeInfo& type_info<Jacobian>();

/// Every type that a port can have.
const std::vector<const TypeInfo*>& port_types();

/// The fields that count for a port with `axes` axes (all, where the type has no axes).
std::size_t field_count(const TypeInfo& type, int axes);

template <typename T>
concept PortValue = std::is_trivially_copyable_v<T> && requires {
  type_info<T>();
};

}  // namespace trocar
