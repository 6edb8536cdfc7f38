// SPDX-License-Identifier: Apache-2.0
#include "framework/port.hpp"

#include <QTest>
#include <random>

#include "framework/component.hpp"

using namespace trocar;

namespace {

struct Ends : Component {
  Output<Pose> pose{this, "pose", {.frame = "device", .doc = "where the tool is"}};
  Output<Joints> joints{this, "joints", {.unit = "m, m, rad"}};
  Output<Jacobian> jacobian{this, "jacobian", {.axes = 3}};
  Output<double> force{this, "force", {.unit = "N"}};
  Input<Vector3> point{this, "point", {.unit = "m"}, {7, 8, 9}};
  Input<double> height{this, "height", {.unit = "m"}};
  Inputs<Vector3> forces{this, "forces", {.unit = "N"}};
  Output<Vector3> a{this, "a", {.unit = "N"}};
  Output<Vector3> b{this, "b", {.unit = "N"}};
  void step(const Tick&) RT_SAFE override {}
};

std::string refusal(const Signature& whole, std::string_view path) {
  try {
    select_field(whole, path);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace

class TestPort : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_field_is_found_by_its_path_data() {
    QTest::addColumn<QString>("port");
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("offset");
    QTest::addColumn<QString>("signature");
    QTest::newRow("the whole") << "pose"
                               << "" << 0 << "Pose [m, 1] in device";
    QTest::newRow("a vector") << "pose"
                              << "position" << 0 << "Vector3 [m] in device";
    QTest::newRow("a number") << "pose"
                              << "position.z" << 16 << "double [m] in device";
    QTest::newRow("of the second block") << "pose"
                                         << "rotation.w" << 48 << "double [1] in device";
    QTest::newRow("an axis") << "joints"
                             << "axis3" << 16 << "double [rad]";
    QTest::newRow("all axes") << "joints"
                              << "" << 0 << "Joints of 3 axes [m, m, rad]";
    QTest::newRow("of a Jacobian") << "jacobian"
                                   << "j12" << 48 << "double [1]";
  }
  void a_field_is_found_by_its_path() {
    QFETCH(QString, port);
    QFETCH(QString, path);
    QFETCH(int, offset);
    QFETCH(QString, signature);
    Ends ends;
    const auto whole = ends.find_output(port.toStdString())->signature();
    const FieldSelection found = select_field(*whole, path.toStdString());
    QCOMPARE(static_cast<int>(found.offset), offset);
    QCOMPARE(QString::fromStdString(found.signature.text()), signature);
  }

  void a_wrong_path_names_what_there_is_data() {
    QTest::addColumn<QString>("port");
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("said");
    QTest::newRow("misspelt") << "pose"
                              << "positon"
                              << "a Pose has no field \"positon\", did you mean \"position\"?";
    QTest::newRow("unlike any") << "pose"
                                << "position.w"
                                << "a Vector3 has no field \"w\", known are x, y, z";
    QTest::newRow("of a number") << "force"
                                 << "x"
                                 << "a double has no fields, \"x\" was asked for";
    QTest::newRow("an axis too many") << "joints"
                                      << "axis4"
                                      << "a Joints has no field \"axis4\", did you mean \"axis1\"?";
    QTest::newRow("a dot at the end") << "pose"
                                      << "position."
                                      << "a Vector3 has no field \"\", known are x, y, z";
  }
  void a_wrong_path_names_what_there_is() {
    QFETCH(QString, port);
    QFETCH(QString, path);
    QFETCH(QString, said);
    Ends ends;
    const auto whole = ends.find_output(port.toStdString())->signature();
    QCOMPARE(QString::fromStdString(refusal(*whole, path.toStdString())), said);
  }

  void a_random_path_is_found_or_refused() {
    Ends ends;
    std::mt19937_64 random(13);
    const std::string words[] = {"position", "rotation", "x", "axis1", "axis9",
                                 "j11",      "",         ".", "\xff"};
    int found = 0;
    for (int i = 0; i < 20000; ++i) {
      std::string path = words[random() % std::size(words)];
      for (std::size_t n = random() % 3; n > 0; --n)
        path += "." + words[random() % std::size(words)];
      for (const OutputPort* port : ends.outputs())
        if (refusal(*port->signature(), path).empty()) {
          ++found;
          QVERIFY(select_field(*port->signature(), path).offset < port->signature()->type->size);
        }
    }
    QVERIFY(found > 100);
  }

  void a_mismatch_says_what_cannot_go_where_data() {
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* name, const char* source, const char* target,
                        const char* said) { QTest::newRow(name) << source << target << said; };
    row("alike", "N", "N", "");
    row("of one dimension", "mm", "m", "");
    row("another unit", "N", "m", "[N] cannot go where [m] is needed");
    row("a moment is no rotational stiffness", "N m", "N m/rad",
        "[N m] cannot go where [N m/rad] is needed");
    row("a number is no angle", "", "rad", "[1] cannot go where [rad] is needed");
    row("other axes", "m, m", "m, m, m", "2 axes cannot go where 3 are needed");
    row("an axis of another unit", "m, rad", "m, m", "[m, rad] cannot go where [m, m] is needed");
  }
  void a_mismatch_says_what_cannot_go_where() {
    QFETCH(QString, source);
    QFETCH(QString, target);
    QFETCH(QString, said);
    const auto signature = [](const QString& units) {
      Signature result{units.contains(',') ? &type_info<Joints>() : &type_info<double>()};
      for (const QString& unit : units.split(','))
        result.units.push_back(parse_unit(unit.toStdString()));
      result.axes = units.contains(',') ? static_cast<int>(result.units.size()) : 0;
      return result;
    };
    QCOMPARE(QString::fromStdString(mismatch(signature(source), signature(target))), said);
  }

  void types_and_frames_must_agree_and_no_frame_agrees_with_any() {
    Signature here{&type_info<Vector3>(), 0, {parse_unit("m")}, "device"};
    Signature there = here;
    QCOMPARE(mismatch(here, there), std::string());
    there.frame = "tool";
    QCOMPARE(mismatch(here, there),
             std::string("a value in frame \"device\" cannot go where frame \"tool\" is needed"));
    there.frame = "";
    QCOMPARE(mismatch(here, there), std::string());
    there.type = &type_info<double>();
    QCOMPARE(mismatch(here, there), std::string("a Vector3 cannot go where a double is needed"));
  }

  void an_input_reads_the_field_and_its_resolution() {
    Ends ends;
    ends.pose->position = {1, 2, 3};
    ends.pose.quality.resolution = {1e-6, 2e-6, 3e-6};
    ends.pose.quality.delay = 2e-3;
    QCOMPARE(ends.point->x, 7.0);
    QVERIFY(!ends.point.connected());
    QCOMPARE(ends.point.resolution(), 0.0);
    ends.point.connect({&ends.pose, 0});
    ends.height.connect({&ends.pose, select_field(*ends.pose.signature(), "position.z").offset});
    QCOMPARE(ends.point->y, 2.0);
    QCOMPARE(*ends.height, 3.0);
    QCOMPARE(ends.height.resolution(), 3e-6);
    QCOMPARE(ends.height.resolution(1), 0.0);
    QCOMPARE(ends.point.resolution(1), 2e-6);
    QCOMPARE(ends.height.delay(), 2e-3);
  }

  void several_sources_are_read_in_the_order_of_their_wires() {
    Ends ends;
    *ends.a = {1, 0, 0};
    *ends.b = {0, 2, 0};
    QCOMPARE(sum(ends.forces).norm(), 0.0);
    ends.forces.connect({&ends.b, 0});
    ends.forces.connect({&ends.a, 0});
    QCOMPARE((*ends.forces.begin())->y, 2.0);
    QCOMPARE(sum(ends.forces), Eigen::Vector3d(1, 2, 0));
    QVERIFY(ends.forces.variadic() && !ends.point.variadic());
  }

  void placing_an_output_keeps_its_value() {
    Ends ends;
    *ends.force = 4.0;
    alignas(double) std::byte memory[sizeof(double)];
    ends.force.place(memory);
    QCOMPARE(*ends.force, 4.0);
    *ends.force = 5.0;
    QCOMPARE(*reinterpret_cast<const double*>(ends.force.data()), 5.0);
    QVERIFY(ends.force.data() == memory);
  }

  void a_declaration_with_too_few_units_is_refused() {
    struct Broken : Ends {
      Output<Wrench> wrench{this, "wrench", {.unit = "N"}};
    };
    QVERIFY_THROWS_EXCEPTION(std::logic_error, Broken());
    struct NoAxes : Ends {
      Output<Joints> none{this, "none", {}};
    };
    QVERIFY_THROWS_EXCEPTION(std::logic_error, NoAxes());
    struct NoColumns : Ends {
      Output<Jacobian> none{this, "none", {}};
    };
    QVERIFY_THROWS_EXCEPTION(std::logic_error, NoColumns());
  }
};

QTEST_APPLESS_MAIN(TestPort)
#include "tst_port.moc"
