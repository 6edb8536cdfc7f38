// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/ros2_decode.hpp"

#include <QTest>
#include <cmath>

using trocar::CdrWriter;
using trocar::Ros2Decoder;
using trocar::Ros2Leaf;
using trocar::Ros2Value;

namespace {

const std::string separator = std::string(80, '=') + '\n';

const std::string row_schema =
    "bool valid\n"
    "int64 tick\n"
    "float64[3] position  # [m]\n"
    "trocar/Wall[2] walls\n" +
    separator +
    "MSG: trocar/Wall\n"
    "uint8 flags\n"
    "float32 depth  # [m]\n";

std::vector<std::byte> row_message() {
  std::vector<std::byte> bytes;
  CdrWriter writer(bytes);
  writer.boolean(true);
  writer.number(std::int64_t{-42});
  for (const double x : {1.5, 2.5, 3.5}) writer.number(x);
  for (const int i : {7, 8}) {
    writer.number(static_cast<std::uint8_t>(i));
    writer.number(static_cast<float>(i) / 2);
  }
  return bytes;
}

const std::string event_schema = "int64 tick\nstring kind\nuint16 code\nstring text\n";

std::vector<std::byte> event_message() {
  std::vector<std::byte> bytes;
  CdrWriter writer(bytes);
  writer.number(std::int64_t{5});
  writer.string("fault");
  writer.number(std::uint16_t{17});
  writer.string("wall.force is NaN");
  return bytes;
}

}  // namespace

class TestRos2Decode : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_fixed_schema_tells_every_place_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<quint64>("offset");  // [B]
    QTest::addColumn<double>("expected");
    QTest::newRow("first field") << "valid" << quint64(4) << 1.0;
    QTest::newRow("aligned to 8 behind a byte") << "tick" << quint64(12) << -42.0;
    QTest::newRow("first of an array") << "position[0]" << quint64(20) << 1.5;
    QTest::newRow("last of an array") << "position[2]" << quint64(36) << 3.5;
    QTest::newRow("inside an array of messages") << "walls[0].flags" << quint64(44) << 7.0;
    QTest::newRow("aligned to 4 inside it") << "walls[0].depth" << quint64(48) << 3.5;
    QTest::newRow("no padding between messages") << "walls[1].flags" << quint64(52) << 8.0;
    QTest::newRow("last field") << "walls[1].depth" << quint64(56) << 4.0;
  }
  void a_fixed_schema_tells_every_place() {
    QFETCH(QString, path);
    QFETCH(quint64, offset);
    QFETCH(double, expected);
    const Ros2Decoder decoder("trocar/msg/Row", row_schema);
    const Ros2Leaf* leaf = decoder.find(path.toStdString());
    QVERIFY(leaf != nullptr);
    QCOMPARE(leaf->offset, offset);
    QCOMPARE(trocar::as_double(decoder.value(row_message(), *leaf)), expected);
  }

  void the_size_is_that_of_the_message() {
    const Ros2Decoder decoder("trocar/msg/Row", row_schema);
    QVERIFY(decoder.is_fixed_size());
    QCOMPARE(decoder.size(), row_message().size());
    QCOMPARE(decoder.leaves().size(), std::size_t(9));
    QCOMPARE(decoder.find("position[1]")->comment, std::string("[m]"));
    QVERIFY(decoder.find("position") == nullptr);
  }

  void every_value_is_visited_in_order() {
    const Ros2Decoder decoder("trocar/msg/Row", row_schema);
    std::vector<double> values;
    QStringList paths;
    decoder.visit(row_message(), [&](const Ros2Leaf& leaf, const Ros2Value& value) {
      paths << QString::fromStdString(leaf.path);
      values.push_back(trocar::as_double(value));
    });
    QCOMPARE(paths.join(' '),
             QString("valid tick position[0] position[1] position[2] walls[0].flags "
                     "walls[0].depth walls[1].flags walls[1].depth"));
    QVERIFY((values == std::vector<double>{1, -42, 1.5, 2.5, 3.5, 7, 3.5, 8, 4}));
  }

  void types_survive() {
    const Ros2Decoder decoder("trocar/msg/Row", row_schema);
    const auto held = [&](const char* path) {
      return decoder.value(row_message(), *decoder.find(path));
    };
    QVERIFY(held("valid") == Ros2Value(true));
    QVERIFY(held("tick") == Ros2Value(std::int64_t{-42}));
    QVERIFY(held("walls[0].flags") == Ros2Value(std::uint64_t{7}));
    QVERIFY(held("walls[0].depth") == Ros2Value(3.5));
  }

  void behind_a_string_places_vary_and_values_are_found() {
    const Ros2Decoder decoder("trocar/msg/Event", event_schema);
    const auto message = event_message();
    QVERIFY(!decoder.is_fixed_size());
    QCOMPARE(decoder.find("kind")->offset, std::size_t(12));
    QCOMPARE(decoder.find("code")->offset, Ros2Leaf::varies);
    const auto held = [&](const char* path) { return decoder.value(message, *decoder.find(path)); };
    QVERIFY(held("kind") == Ros2Value(std::string_view("fault")));
    QVERIFY(held("code") == Ros2Value(std::uint64_t{17}));
    QVERIFY(held("text") == Ros2Value(std::string_view("wall.force is NaN")));
    QVERIFY(std::isnan(trocar::as_double(held("text"))));
  }

  void extremes_of_every_type_survive() {
    std::vector<std::byte> message;
    CdrWriter writer(message);
    writer.number(std::int8_t{-128});
    writer.number(std::int16_t{-32768});
    writer.number(std::uint16_t{65535});
    writer.number(std::int32_t{-2147483647});
    writer.number(std::uint32_t{4294967295});
    writer.number(std::uint64_t{18446744073709551615u});
    const Ros2Decoder decoder("a/B", "int8 a\nint16 b\nuint16 c\nint32 d\nuint32 e\nuint64 f\n");
    std::vector<Ros2Value> values;
    decoder.visit(message,
                  [&](const Ros2Leaf&, const Ros2Value& value) { values.push_back(value); });
    const std::vector<Ros2Value> expected = {
        std::int64_t{-128},        std::int64_t{-32768},      std::uint64_t{65535},
        std::int64_t{-2147483647}, std::uint64_t{4294967295}, std::uint64_t{18446744073709551615u}};
    QVERIFY(values == expected);
  }

  void a_message_that_does_not_fit_is_refused() {
    const Ros2Decoder decoder("trocar/msg/Event", event_schema);
    const auto ignore = [](const Ros2Leaf&, const Ros2Value&) {};
    auto message = event_message();
    for (std::size_t size = 0; size < message.size(); ++size)
      QVERIFY_THROWS_EXCEPTION(std::runtime_error,
                               decoder.visit(std::span(message).first(size), ignore));
    message.resize(message.size() + 4);
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, decoder.visit(message, ignore));
    const Ros2Decoder row("trocar/msg/Row", row_schema);
    QVERIFY_THROWS_EXCEPTION(std::runtime_error,
                             row.value(std::span(message).first(20), row.leaves().back()));
  }

  void a_schema_that_explodes_is_refused_data() {
    QTest::addColumn<QByteArray>("schema");
    QTest::newRow("one long array") << QByteArray("float64[4000000000] x\n");
    QByteArray nested;
    for (const char* next : {"B", "C", "D", "E"}) {
      nested += QByteArray("a/") + next + "[1000] x\n" + QByteArray::fromStdString(separator);
      nested += QByteArray("MSG: a/") + next + "\n";
    }
    QTest::newRow("arrays of arrays") << nested + "bool x\n";
  }
  void a_schema_that_explodes_is_refused() {
    QFETCH(QByteArray, schema);
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, Ros2Decoder("a/A", schema.toStdString()));
  }
};

QTEST_APPLESS_MAIN(TestRos2Decode)
#include "tst_ros2_decode.moc"
