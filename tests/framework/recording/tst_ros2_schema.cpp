// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/ros2_schema.hpp"

#include <QTest>

using trocar::Ros2Field;
using trocar::Ros2Message;

Q_DECLARE_METATYPE(std::vector<Ros2Message>)

namespace {

Ros2Message one_field(const char* message, const char* field, const char* type) {
  return {message, {{field, type}}, {}};
}

template <typename Call>
QString message_of(Call&& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

}  // namespace

class TestRos2Schema : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_text_is_that_of_ros2msg() {
    const std::string text = trocar::ros2_schema_text({
        {"trocar/Row",
         {{"tick", "int64"},
          {"position", "float64", 3, "[m], world frame"},
          {"wall", "trocar/Wall", 0, "the soft one"}},
         "One row a tick."},
        {"trocar/Wall", {{"touched", "bool"}}, ""},
    });
    const std::string expected =
        "# One row a tick.\n"
        "int64 tick\n"
        "float64[3] position  # [m], world frame\n"
        "trocar/Wall wall  # the soft one\n" +
        std::string(80, '=') +
        "\nMSG: trocar/Wall\n"
        "bool touched\n";
    QCOMPARE(QString::fromStdString(text), QString::fromStdString(expected));
  }

  void what_is_written_is_parsed() {
    const std::vector<Ros2Message> messages = {
        {"trocar/Row",
         {{"tick", "int64", 0, "number of the tick"}, {"walls", "trocar/Wall", 2, ""}},
         "One row a tick."},
        {"trocar/Wall", {{"force", "geometry/Vector", 0, "[N] # world"}}, ""},
        {"geometry/Vector", {{"x", "float64"}, {"y", "float64"}, {"name", "string"}}, ""},
    };
    const std::string text = trocar::ros2_schema_text(messages);
    QVERIFY(trocar::parse_ros2_schema("trocar/msg/Row", text) == messages);
  }

  void the_forms_of_other_writers_are_parsed() {
    const auto messages = trocar::parse_ros2_schema("pkg/msg/Top",
                                                    "uint8 RED=1\r\n"
                                                    "int32 LIMIT = 5\n"
                                                    "\n"
                                                    "  float32 \t gain 1.5 # with a default\n"
                                                    "Inner inner\n"
                                                    "==========\n"
                                                    "MSG: pkg/msg/Inner\n"
                                                    "string text\n");
    const std::vector<Ros2Message> expected = {
        {"pkg/Top", {{"gain", "float32", 0, "with a default"}, {"inner", "pkg/Inner", 0, ""}}, ""},
        {"pkg/Inner", {{"text", "string"}}, ""},
    };
    QVERIFY(messages == expected);
  }

  void names_and_types_are_checked_data() {
    QTest::addColumn<std::vector<Ros2Message>>("messages");
    QTest::addColumn<QString>("text");  // empty: allowed
    using List = std::vector<Ros2Message>;
    const auto row = [](const char* name, const List& messages, const char* text) {
      QTest::newRow(name) << messages << QString(text);
    };
    row("a plain field", {one_field("a/B", "x", "float64")}, "");
    row("digits inside a name", {one_field("a/B", "q1_dot2", "float64")}, "");
    row("a capital letter", {one_field("a/B", "Force", "float64")}, "'Force'");
    row("a digit first", {one_field("a/B", "1st", "float64")}, "'1st'");
    row("an underscore first", {one_field("a/B", "_x", "float64")}, "'_x'");
    row("an underscore last", {one_field("a/B", "x_", "float64")}, "'x_'");
    row("two underscores", {one_field("a/B", "x__y", "float64")}, "'x__y'");
    row("a dot", {one_field("a/B", "x.y", "float64")}, "'x.y'");
    row("no name", {one_field("a/B", "", "float64")}, "''");
    row("a message without package", {one_field("B", "x", "float64")}, "message name 'B'");
    row("a message in lower case", {one_field("a/b", "x", "float64")}, "message name 'a/b'");
    row("an unknown primitive", {one_field("a/B", "x", "double")}, "type 'double'");
    row("an undefined message", {one_field("a/B", "x", "a/C")}, "'a/C' of 'a/B.x' is not defined");
    row("no message", {}, "needs a message");
    row("no field", {{"a/B", {}, ""}}, "at least one field");
    row("a field twice", {{"a/B", {{"x", "bool"}, {"x", "bool"}}, ""}}, "stands twice");
    row("a message twice", {one_field("a/B", "x", "bool"), one_field("a/B", "x", "bool")},
        "defined twice");
    row("a message inside itself", {one_field("a/B", "x", "a/C"), one_field("a/C", "x", "a/B")},
        "contains itself");
    row("a comment of two lines", {{"a/B", {{"x", "bool", 0, "one\ntwo"}}, ""}}, "one line");
  }
  void names_and_types_are_checked() {
    QFETCH(std::vector<Ros2Message>, messages);
    QFETCH(QString, text);
    const QString said = message_of([&] { trocar::ros2_schema_text(messages); });
    QCOMPARE(said.isEmpty(), text.isEmpty());
    QVERIFY2(said.contains(text), qPrintable(said));
  }

  void nesting_has_a_limit() {
    std::vector<Ros2Message> messages;
    for (int i = 0; i < 40; ++i)
      messages.push_back({"a/M" + std::to_string(i), {{"x", "a/M" + std::to_string(i + 1)}}, ""});
    messages.push_back(one_field("a/M40", "x", "bool"));
    const QString said = message_of([&] { trocar::ros2_schema_text(messages); });
    QVERIFY2(said.contains("more than 32 deep"), qPrintable(said));
  }

  void wrong_text_is_refused_with_its_line_data() {
    QTest::addColumn<QByteArray>("schema");
    QTest::addColumn<QString>("text");
    QTest::newRow("empty") << QByteArray() << "at least one field";
    QTest::newRow("a type alone") << QByteArray("bool x\nfloat64\n") << "line 2";
    QTest::newRow("an array of any length") << QByteArray("bool[] x\n") << "fixed length";
    QTest::newRow("a bounded array") << QByteArray("bool[<=3] x\n") << "fixed length";
    QTest::newRow("an array of length zero") << QByteArray("bool[0] x\n") << "fixed length";
    QTest::newRow("an open bracket") << QByteArray("bool[3 x\n") << "fixed length";
    QTest::newRow("only a bracket") << QByteArray("bool[ x\n") << "fixed length";
    QTest::newRow("a negative length") << QByteArray("bool[-1] x\n") << "fixed length";
    QTest::newRow("a length of many digits")
        << QByteArray("bool[99999999999] x\n") << "fixed length";
    QTest::newRow("no name behind the line")
        << QByteArray("bool x\n====\nbool y\n") << "line 3: 'MSG:";
    QTest::newRow("cut behind the line") << QByteArray("bool x\n====") << "'MSG:";
    QTest::newRow("bytes that are no text") << QByteArray("\xff\xfe\0\x01 \x80", 6) << "ros2msg";
  }
  void wrong_text_is_refused_with_its_line() {
    QFETCH(QByteArray, schema);
    QFETCH(QString, text);
    const QString said =
        message_of([&] { trocar::parse_ros2_schema("a/B", schema.toStdString()); });
    QVERIFY2(said.contains(text) && !said.isEmpty(), qPrintable(said));
  }
};

QTEST_APPLESS_MAIN(TestRos2Schema)
#include "tst_ros2_schema.moc"
