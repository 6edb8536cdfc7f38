// SPDX-License-Identifier: Apache-2.0
#include "framework/types.hpp"

#include <QTest>
#include <cstring>

using namespace trocar;

namespace {

static_assert(PortValue<double> && PortValue<std::int64_t> && PortValue<bool> &&
              PortValue<Enumeration> && PortValue<Vector3> && PortValue<Rotation> &&
              PortValue<Pose> && PortValue<PointMotion> && PortValue<Twist> && PortValue<Wrench> &&
              PortValue<Joints> && PortValue<Jacobian>);
static_assert(!PortValue<Eigen::Vector3d>, "Eigen's own matrices are not trivially copyable");

/// Every byte of a composite belongs to exactly one number.
bool covered(const TypeInfo& type, std::size_t base, std::vector<int>& bytes) {
  if (type.fields.empty()) {
    for (std::size_t i = 0; i < type.size; ++i) ++bytes[base + i];
    return type.scalar == Scalar::real;
  }
  bool all = true;
  for (const TypeField& field : type.fields)
    all = covered(*field.type, base + field.offset, bytes) && all;
  return all;
}

}  // namespace

class TestTypes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_table_of_fields_tells_sizes_without_padding() {
    const std::pair<const TypeInfo*, std::size_t> sizes[] = {
        {&type_info<Vector3>(), sizeof(Vector3)}, {&type_info<Rotation>(), sizeof(Rotation)},
        {&type_info<Pose>(), sizeof(Pose)},       {&type_info<PointMotion>(), sizeof(PointMotion)},
        {&type_info<Twist>(), sizeof(Twist)},     {&type_info<Wrench>(), sizeof(Wrench)},
        {&type_info<Joints>(), sizeof(Joints)},   {&type_info<Jacobian>(), sizeof(Jacobian)}};
    for (const auto& [type, size] : sizes) {
      QCOMPARE(type->size, size);
      std::vector<int> bytes(size, 0);
      QVERIFY2(covered(*type, 0, bytes), "a composite holds numbers only");
      QCOMPARE(std::count(bytes.begin(), bytes.end(), 1), static_cast<std::ptrdiff_t>(size));
    }
    QCOMPARE(port_types().size(), std::size_t{12});
  }

  void every_field_has_a_unit_of_its_type() {
    for (const TypeInfo* type : port_types())
      for (const TypeField& field : type->fields)
        QVERIFY(type->per_axis == 1 || field.block < type->units.size());
  }

  void an_offset_finds_the_member() {
    const Pose pose{{1, 2, 3}, Rotation(Eigen::Quaterniond(7, 4, 5, 6))};
    double numbers[7];
    std::memcpy(numbers, &pose, sizeof pose);
    for (int i = 0; i < 7; ++i) QCOMPARE(numbers[i], i + 1.0);
    QCOMPARE(type_info<Pose>().fields[1].name, std::string("rotation"));
    QCOMPARE(type_info<Pose>().fields[1].offset, offsetof(Pose, rotation));
    QCOMPARE(type_info<Wrench>().fields[1].offset, offsetof(Wrench, moment));
    QCOMPARE(type_info<PointMotion>().fields[1].offset, offsetof(PointMotion, velocity));
  }

  void a_jacobian_lies_column_by_column() {
    Jacobian jacobian;
    jacobian.head<3>()(4, 2) = 9.0;
    QCOMPARE(jacobian.column[2][4], 9.0);
    const TypeField& field = type_info<Jacobian>().fields[2 * 6 + 4];
    QCOMPARE(field.name, std::string("j53"));
    double found = 0.0;
    std::memcpy(&found, reinterpret_cast<const char*>(&jacobian) + field.offset, sizeof found);
    QCOMPARE(found, 9.0);
    QCOMPARE(field_count(type_info<Jacobian>(), 3), std::size_t{18});
    QCOMPARE(field_count(type_info<Joints>(), 3), std::size_t{3});
    QCOMPARE(field_count(type_info<Wrench>(), 0), std::size_t{2});
  }

  void views_share_the_numbers() {
    Wrench wrench;
    wrench.eigen()[4] = 2.0;
    QCOMPARE(wrench.moment.y, 2.0);
    QCOMPARE(Rotation().eigen().w(), 1.0);
  }
};

QTEST_APPLESS_MAIN(TestTypes)
#include "tst_types.moc"
