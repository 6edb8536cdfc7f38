// SPDX-License-Identifier: Apache-2.0
#include "framework/parameter.hpp"

#include <QTest>
#include <limits>
#include <numbers>

#include "framework/parameter_set.hpp"

using namespace trocar;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Settings : ParameterSet {
  Parameter<double> stiffness{
      this, "stiffness", {.unit = "N/m", .initial = "2.2 N/mm", .min = "0 N/mm", .max = "50 N/mm"}};
  Parameter<double> force{this, "force", {.unit = "N"}};
  Parameter<double> mass{this, "mass", {.unit = "kg", .initial = "1 kg", .min = "100 g"}};
  Parameter<double> tilt{
      this, "tilt", {.unit = "rad", .initial = "0", .min = "-60 deg", .max = "60 deg"}};
  Parameter<double> gain{this, "gain", {.initial = "1", .max = "10"}};
  Parameter<std::int64_t> levels{this, "levels", {.initial = "9", .min = "1", .max = "100"}};
  Parameter<bool> on{this, "on", {.initial = "true"}};
  Parameter<std::string> file{this, "file", {.initial = "wall.lua"}};
  Parameter<Choice> hand{this, "hand", {.initial = "none", .choices = {"none", "push", "trace"}}};
  Parameter<Vector3> point{this, "point", {.unit = "m", .initial = "0, 0, 105 mm"}};
  Parameter<Rotation> mount{this, "mount", {.unit = "rad", .initial = "pitch = 20 deg"}};
  Parameter<Joints> start{this, "start", {.unit = "m", .initial = "1 mm, 2 mm"}};
  Parameter<Quantity> value{this, "value", {.initial = "3 mm"}};
  Parameter<Literal> any{this, "any", {.initial = "1"}};
};

Literal list(std::initializer_list<Literal> parts) {
  return {Literal::List(parts)};
}
Literal text(const char* string) {
  return {std::string(string)};
}

}  // namespace

class TestParameter : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_wrong_value_says_what_would_be_right_data() {
    QTest::addColumn<QString>("parameter");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* name, const char* parameter, const char* value,
                        const char* said) {
      QTest::newRow(name) << parameter << value << QString::fromUtf8(said);
    };
    row("another unit", "stiffness", "2.2 N", "needs N/m, e.g. \"2.2 N/mm\" (0–50 N/mm)");
    row("a bare number", "stiffness", "3", "needs N/m, e.g. \"3 N/mm\" (0–50 N/mm)");
    row("an example never breaks the range itself", "stiffness", "2200 N",
        "needs N/m, e.g. \"1 N/mm\" (0–50 N/mm)");
    row("a number in its own unit only", "gain", "3 N", "needs a number without a unit");
    row("without a range", "force", "2 mm", "needs N, e.g. \"2 N\"");
    row("with a lower bound only", "mass", "2 N", "needs kg, e.g. \"2 kg\" (at least 0.1 kg)");
    row("no unit at all", "force", "2 parsec",
        "\"2 parsec\": \"parsec\": \"parsec\" is no unit, known are m g s A K rad deg rev N Pa J W "
        "V Hz min h % with the prefixes µ m c d k M");
    row("Nm", "force", "2 Nm", "\"2 Nm\": \"Nm\": \"Nm\" is no unit, write \"N m\"");
    row("no number", "force", "hard", "\"hard\" is no quantity, a number and a unit are needed");
    row("too large", "stiffness", "51 N/mm", "must be within 0–50 N/mm");
    row("negative", "stiffness", "-1 N/mm", "must be within 0–50 N/mm");
    row("infinite", "stiffness", "inf N/mm", "must be a finite number");
    row("below the only bound", "mass", "1 g", "must be at least 0.1 kg");
    row("above the only bound", "gain", "11", "must be at most 10");
    row("a range about zero", "tilt", "61 deg", "must be within -60 to 60 deg");
    row("NaN", "force", "nan N", "\"nan N\" is no quantity, a number and a unit are needed");
    row("a fraction of a whole number", "levels", "2.5", "needs a whole number");
    row("a whole number out of range", "levels", "0", "must be within 1–100");
    row("a truth value for a number", "force", "true", "needs a quantity in N");
    row("a truth value for a plain number", "gain", "true", "needs a number");
    row("a number for a truth value", "on", "1", "needs true or false");
    row("a number for a string", "file", "1", "needs a string");
    row("a near choice", "hand", "pusch",
        "needs one of \"none\", \"push\", \"trace\", did you mean \"push\"?");
    row("a far choice", "hand", "sideways", "needs one of \"none\", \"push\", \"trace\"");
    row("a number for a choice", "hand", "2", "needs one of \"none\", \"push\", \"trace\"");
    row("two for three", "point", "0, 0", "needs 3 values, got 2");
    row("a wrong part", "point", "0, 0, 3 N", "needs m, e.g. \"3 m\"");
    row("an unknown part", "point", "w = 3 mm", "has no \"w\", known are x, y, z");
    row("one for three", "point", "3 mm", "needs a list of 3 values or a table with x, y, z");
    row("a misspelt angle", "mount", "pich = 3 deg", "has no \"pich\", did you mean \"pitch\"?");
    row("a bare angle", "mount", "pitch = 3", "needs rad, e.g. \"3 rad\"");
    row("nine axes", "start", "0,0,0,0,0,0,0,0,0",
        "needs a list of up to 8 numbers, one for each axis");
    row("a list for any quantity", "value", "1, 2", "needs a quantity, e.g. \"3 mm\"");
  }
  void a_wrong_value_says_what_would_be_right() {
    QFETCH(QString, parameter);
    QFETCH(QString, value);
    QFETCH(QString, said);
    Settings settings;
    ParameterBase* found = settings.find_parameter(parameter.toStdString());
    QVERIFY(found != nullptr);
    const std::string before = found->text();
    const Literal literal = literal_from_text(value.toStdString());
    QCOMPARE(QString::fromStdString(found->check(literal)), said);
    QCOMPARE(QString::fromStdString(found->set(literal)), said);
    QCOMPARE(found->text(), before);
  }

  void a_right_value_is_taken_and_printed_data() {
    QTest::addColumn<QString>("parameter");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("printed");
    const auto row = [](const char* name, const char* parameter, const char* value,
                        const char* printed) {
      QTest::newRow(name) << parameter << value << printed;
    };
    row("a quantity", "stiffness", "3 N/mm", "3 N/mm");
    row("zero needs no unit", "stiffness", "0", "0 N/mm");
    row("zero as text neither", "force", "0.0", "0 N");
    row("negative", "force", "-2 mN", "-0.002 N");
    row("the bound itself", "stiffness", "50 N/mm", "50 N/mm");
    row("infinite where nothing bounds it", "force", "inf N", "inf N");
    row("degrees", "tilt", "-60 deg", "-60 deg");
    row("a number", "gain", "0.5", "0.5");
    row("percent", "gain", "50 %", "0.5");
    row("a whole number", "levels", "12", "12");
    row("false", "on", "false", "false");
    row("a string", "file", "other.lua", "\"other.lua\"");
    row("a string that looks like a number", "file", "\"5\"", "\"5\"");
    row("a choice", "hand", "trace", "\"trace\"");
    row("a list", "point", "1 mm, 0, -2 cm", "{0.001 m, 0 m, -0.02 m}");
    row("a table leaves the rest", "point", "x = 1 mm", "{0.001 m, 0 m, 0.105 m}");
    row("angles", "mount", "roll = 10 deg, yaw = -30 deg",
        "{roll = \"10 deg\", pitch = \"0 deg\", yaw = \"-30 deg\"}");
    row("axes", "start", "{5 mm}", "{0.005, 0.002, 0, 0, 0, 0, 0, 0}");
    row("any unit", "value", "4 N", "4 N");
    row("no unit for any quantity", "value", "4", "4");
    row("any value", "any", "{a = 1}", "{a = 1}");
  }
  void a_right_value_is_taken_and_printed() {
    QFETCH(QString, parameter);
    QFETCH(QString, value);
    QFETCH(QString, printed);
    Settings settings;
    ParameterBase* found = settings.find_parameter(parameter.toStdString());
    QCOMPARE(QString::fromStdString(found->set(literal_from_text(value.toStdString()))), QString());
    QCOMPARE(QString::fromStdString(found->text()), printed);
  }

  void values_that_only_a_program_can_write_are_checked() {
    Settings settings;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(settings.gain.set({nan}), std::string("must be a finite number"));
    QCOMPARE(settings.value.set({nan}), std::string("must be a finite number"));
    QCOMPARE(settings.gain.set({-infinity}), std::string());
    QCOMPARE(settings.gain.set({}), std::string("needs a number"));
    QVERIFY(!settings.point.set(list({{0.0}, {0.0}, list({})})).empty());
    QCOMPARE(settings.point.set(list({{0.0}, text("1 mm"), {0.0}})), std::string());
    QCOMPARE(settings.point->y, 1e-3);
  }

  void a_list_that_is_wrong_at_its_end_changes_nothing() {
    Settings settings;
    QVERIFY(!settings.point.set(list({text("9 mm"), text("9 mm"), text("9 N")})).empty());
    QCOMPARE(settings.point->x, 0.0);
    QVERIFY(!settings.start.set(list({text("9 mm"), text("9 N")})).empty());
    QCOMPARE((*settings.start)[0], 1e-3);
  }

  void roll_pitch_and_yaw_turn_about_fixed_axes() {
    Settings settings;
    QCOMPARE(settings.mount.set(literal_from_text("90 deg, 0, 90 deg")), std::string());
    const Eigen::Vector3d turned = settings.mount->eigen() * Eigen::Vector3d::UnitY();
    QVERIFY((turned - Eigen::Vector3d::UnitZ()).norm() < 1e-15);
    const Eigen::Vector3d other = settings.mount->eigen() * Eigen::Vector3d::UnitX();
    QVERIFY((other - Eigen::Vector3d::UnitY()).norm() < 1e-15);
  }

  void a_component_narrows_a_range_with_its_reason() {
    Settings settings;
    settings.stiffness.limit(11900.0, "the loop is stable up to there");
    QCOMPARE(settings.stiffness.set(text("12 N/mm")),
             std::string("must be at most 11.9 N/mm: the loop is stable up to there"));
    QCOMPARE(settings.stiffness.set(text("11.9 N/mm")), std::string());
    settings.stiffness.limit(30000.0, "a wider limit that changes nothing");
    QCOMPARE(settings.stiffness.max(), 11900.0);
    QCOMPARE(settings.stiffness.limit_reason(), std::string("the loop is stable up to there"));
    QCOMPARE(settings.stiffness.set(text("-1 N/mm")), std::string("must be within 0–11.9 N/mm"));
  }

  void required_and_assigned() {
    Settings settings;
    QVERIFY(settings.force.required() && !settings.force.assigned());
    QVERIFY(!settings.stiffness.required() && settings.stiffness.assigned());
    const std::any before = settings.force.save();
    QVERIFY(!settings.force.set(text("1 mm")).empty());
    QVERIFY(!settings.force.assigned());
    QCOMPARE(settings.force.set(text("1 N")), std::string());
    QVERIFY(settings.force.assigned());
    settings.force.restore(before);
    QVERIFY(!settings.force.assigned());
    QCOMPARE(*settings.force, 0.0);
  }

  void numbers_are_what_a_live_edit_moves() {
    Settings settings;
    QCOMPARE(settings.stiffness.numbers().size(), std::size_t{1});
    QCOMPARE(settings.point.numbers().size(), std::size_t{3});
    QCOMPARE(settings.hand.numbers().size(), std::size_t{0});
    settings.point.numbers()[2] = 7.0;
    QCOMPARE(settings.point->z, 7.0);
  }

  void a_declaration_that_contradicts_itself_is_refused() {
    struct Broken : ParameterSet {
      Parameter<double> force{this, "force", {.unit = "N", .initial = "3 mm"}};
    };
    QVERIFY_THROWS_EXCEPTION(std::logic_error, Broken());
    struct Bounds : ParameterSet {
      Parameter<double> force{this, "force", {.unit = "N", .max = "3 mm"}};
    };
    QVERIFY_THROWS_EXCEPTION(std::logic_error, Bounds());
  }
};

QTEST_APPLESS_MAIN(TestParameter)
#include "tst_parameter.moc"
