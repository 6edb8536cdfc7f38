// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/row_layout.hpp"

#include <QTest>
#include <map>

#include "framework/recording/ros2_decode.hpp"
#include "tests/support/test_components.hpp"

using namespace trocar;

namespace {

/// One output of each kind, odd sizes first.
struct Everything final : Component {
  Output<bool> flag{this, "flag", {}};
  Output<double> number{this, "number", {.unit = "N"}};
  Output<bool> second{this, "second", {}};
  Output<bool> third{this, "third", {}};
  Output<std::int64_t> count{this, "count", {.doc = "of contacts"}};
  Output<Enumeration> state{this, "state", {.labels = {"out", "in"}}};
  Output<Joints> joints{this, "joints", {.unit = "m, m, rad"}};
  Output<PointMotion> tip{this, "tip", {.frame = "device"}};
  Output<Jacobian> jacobian{this, "jacobian", {.axes = 2}};
  Output<bool> last{this, "last", {}};
  void step(const Tick&) RT_SAFE override {}
};

struct LayoutRig {
  Registry types = test::registry();
  Graph graph{types};
  std::unique_ptr<WiredGraph> wired;

  LayoutRig() { types.add<Everything>("Everything", "test", "one output of each kind"); }
  LayoutRig(const LayoutRig&) = delete;
  LayoutRig& operator=(const LayoutRig&) = delete;
  void add(std::string_view type, std::string_view name, std::string_view scope = "") {
    graph.add(type, name, {"test", 1}, scope).value();
  }
  RowLayout layout(const RowLayout::Selection& wanted = {}) {
    wired = wire(graph, {});
    return RowLayout(wired->main(), wanted);
  }
};

QStringList names_of(const RowLayout& layout) {
  QStringList names;
  for (const RowPort& port : layout.ports()) names += QString::fromStdString(port.name);
  return names;
}

}  // namespace

class TestRowLayout : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void every_value_stands_where_cdr_puts_it_data() {
    QTest::addColumn<int>("components");  // an even or odd number of 8-byte heads before the ports
    QTest::newRow("one component") << 1;
    QTest::newRow("three, each ending in a bool") << 3;
  }
  void every_value_stands_where_cdr_puts_it() {
    QFETCH(int, components);
    LayoutRig rig;
    for (int i = 0; i < components; ++i) rig.add("Everything", "e" + std::to_string(i));
    const RowLayout layout = rig.layout();
    const Ros2Decoder decoder("trocar/Row", ros2_schema_text(layout.messages()));
    QCOMPARE(decoder.size(), layout.size() + cdr_head);
    std::size_t leaves = 0;
    for (const RowSignal& signal : layout.signals()) {
      const Ros2Leaf* leaf = decoder.find(signal.name);
      QVERIFY2(leaf != nullptr, signal.name.c_str());
      QVERIFY2(leaf->offset == signal.row_offset + cdr_head, signal.name.c_str());
      QCOMPARE(leaf->type == Ros2Type::boolean, signal.scalar == Scalar::boolean);
      QCOMPARE(leaf->type == Ros2Type::int64, signal.scalar == Scalar::integer);
      ++leaves;
    }
    // Beside the signals: the head's five numbers and a time for each component.
    QCOMPARE(decoder.leaves().size(), leaves + 5 + static_cast<std::size_t>(components));
  }

  void a_captured_row_reads_back() {
    LayoutRig rig;
    rig.add("Everything", "one");
    rig.add("Everything", "two");
    const RowLayout layout = rig.layout();
    auto& two = *static_cast<Everything*>(rig.wired->find("two"));
    *two.flag = true;
    *two.third = true;
    *two.count = -7;
    two.state->index = 1;
    two.joints->head<3>() = Eigen::Vector3d(1.5, 2.5, 3.5);
    two.tip->velocity = {4.5, 5.5, 6.5};
    two.jacobian->column[1][5] = 7.5;
    std::vector<std::byte> message(cdr_head + layout.size(), std::byte{0});
    message[1] = std::byte{1};
    const std::vector<std::int64_t> times = {11, 12};
    layout.capture({.tick = 3, .time = 4, .lateness = 5, .duration = 6, .flags = 7}, times,
                   rig.wired->main().memory(), std::span(message).subspan(cdr_head));
    const Ros2Decoder decoder("trocar/Row", ros2_schema_text(layout.messages()));
    std::map<std::string, double> expected = {{"tick", 3},
                                              {"time", 4},
                                              {"lateness", 5},
                                              {"duration", 6},
                                              {"flags", 7},
                                              {"step_times.one", 11},
                                              {"step_times.two", 12},
                                              {"two.flag", 1},
                                              {"two.third", 1},
                                              {"two.count", -7},
                                              {"two.state", 1},
                                              {"two.joints.axis1", 1.5},
                                              {"two.joints.axis2", 2.5},
                                              {"two.joints.axis3", 3.5},
                                              {"two.tip.velocity.x", 4.5},
                                              {"two.tip.velocity.y", 5.5},
                                              {"two.tip.velocity.z", 6.5}};
    double sum = 0.0;
    for (const Ros2Leaf& leaf : decoder.leaves()) {
      const double value = as_double(decoder.value(message, leaf));
      sum += value;
      const auto found = expected.find(leaf.path);
      if (found == expected.end()) continue;
      QVERIFY2(value == found->second, leaf.path.c_str());
      sum -= value;
      expected.erase(found);
    }
    QVERIFY2(expected.empty(), expected.empty() ? "" : expected.begin()->first.c_str());
    QCOMPARE(sum, 7.5);  // the Jacobian's, and nothing else
  }

  void of_an_array_of_axes_only_those_that_count_are_recorded() {
    LayoutRig rig;
    rig.add("Everything", "one");
    const RowLayout layout = rig.layout();
    for (const RowPort& port : layout.ports()) {
      if (port.name == "one.joints") QCOMPARE(port.size, std::size_t{3 * 8});
      if (port.name == "one.jacobian") QCOMPARE(port.size, std::size_t{2 * 6 * 8});
    }
  }

  void a_selection_takes_what_it_wants_and_every_device() {
    LayoutRig rig;
    rig.add("TestDevice", "arm");
    rig.add("Everything", "one");
    const QStringList all = names_of(rig.layout());
    const QStringList some =
        names_of(rig.layout([](const std::string& port) { return port == "one.tip"; }));
    QCOMPARE(some.filter("one."), QStringList{"one.tip"});
    QCOMPARE(some.filter("arm."), all.filter("arm."));
    QVERIFY(!some.filter("arm.effort_sent").isEmpty());
  }

  void every_graph_has_a_schema_data() {
    QTest::addColumn<QStringList>("names");  // "scope.name" or "name"
    QTest::newRow("no component") << QStringList{};
    QTest::newRow("a group that reads like a component") << QStringList{"a.b", "a_b"};
    QTest::newRow("groups whose underscores move") << QStringList{"a_b.c", "a.b_c"};
    QTest::newRow("names of the row's own") << QStringList{"tick", "time", "flags", "step_times"};
    QTest::newRow("capitals") << QStringList{"leftWall", "leftwall", "LEFT"};
    QTest::newRow("underscores that ROS does not take") << QStringList{"a__b", "a_b", "a_"};
    QTest::newRow("deep") << QStringList{"a.b.c.d.e.f"};
  }
  void every_graph_has_a_schema() {
    QFETCH(QStringList, names);
    LayoutRig rig;
    for (const QString& name : names) {
      const int dot = static_cast<int>(name.lastIndexOf('.'));
      rig.add("Everything", name.mid(dot + 1).toStdString(),
              name.left(std::max(0, dot)).toStdString());
    }
    const RowLayout layout = rig.layout();
    const Ros2Decoder decoder("trocar/Row", ros2_schema_text(layout.messages()));
    QCOMPARE(decoder.size(), layout.size() + cdr_head);
    std::size_t next = 5 + static_cast<std::size_t>(names.size());
    for (const RowSignal& signal : layout.signals())
      QCOMPARE(decoder.leaves().at(next++).offset, signal.row_offset + cdr_head);
  }

  void a_field_says_unit_frame_and_labels() {
    LayoutRig rig;
    rig.add("Everything", "one");
    const std::string text = ros2_schema_text(rig.layout().messages());
    QVERIFY(text.find("float64 number  # [N]") != std::string::npos);
    QVERIFY(text.find("int64 state  # 0 out, 1 in") != std::string::npos);
    QVERIFY(text.find("trocar/PointMotion tip  # [m, m/s] in device") != std::string::npos);
    QVERIFY(text.find("int64 count  # of contacts") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(TestRowLayout)
#include "tst_row_layout.moc"
