// SPDX-License-Identifier: Apache-2.0
#include "framework/wired_graph.hpp"

#include <QTest>

#include "tests/support/test_components.hpp"

using namespace trocar;

namespace {

/// A graph whose mistakes stand at lines of "rig.lua", counted as it is written.
struct Rig {
  Registry types = test::registry();
  Graph graph{types};
  WiringOptions options{};
  int line = 0;

  Where here() { return {"rig.lua", ++line}; }
  NodeId add(std::string_view type, std::string_view name = "") {
    return graph.add(type, name, here()).value();
  }
  /// @param output a port, or a field of one: "position.axis1"
  void wire(NodeId from, std::string_view output, NodeId to, std::string_view input) {
    const bool is_port = graph.node(from).component->find_output(output) != nullptr;
    const std::size_t dot = is_port ? output.size() : std::min(output.find('.'), output.size());
    graph.connect({from, std::string(output.substr(0, dot)),
                   std::string(dot < output.size() ? output.substr(dot + 1) : "")},
                  {to, std::string(input)}, here());
  }
  void set(NodeId node, std::string_view parameter, std::string_view value) {
    graph.set({node, std::string(parameter)}, literal_from_text(value), here());
  }
  QString findings() const {
    return QString::fromStdString(check(graph, options).text()).trimmed();
  }
  QString order() const {
    QStringList names;
    const auto wired = trocar::wire(graph, options);
    for (const ScheduleItem& item : wired->main().schedule())
      names += QString::fromStdString(item.component->name());
    return names.join(" ");
  }
  Rig() = default;
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;
};

}  // namespace

class TestWiring : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_order_is_devices_then_wiring_then_declaration_and_late_inputs_where_free() {
    Rig rig;
    const NodeId last = rig.add("Follower", "last");
    const NodeId first = rig.add("Number", "first");
    const NodeId second = rig.add("Number", "second");
    rig.add("TestDevice", "device");
    rig.wire(first, "value", last, "input");
    rig.wire(second, "value", last, "late");
    QCOMPARE(rig.order(), QString("device first second last"));
  }

  void a_loop_is_refused_with_its_path() {
    Rig rig;
    const NodeId a = rig.add("Follower", "a");
    const NodeId b = rig.add("Follower", "b");
    const NodeId c = rig.add("Follower", "c");
    rig.wire(a, "value", b, "input");
    rig.wire(b, "value", a, "input");
    rig.wire(b, "value", c, "input");
    QVERIFY2(rig.findings().endsWith("a loop without a delay: b.value → a.input, a.value → "
                                     "b.input; break it with trocar.Delay") ||
                 rig.findings().endsWith("a loop without a delay: a.value → b.input, b.value → "
                                         "a.input; break it with trocar.Delay"),
             qPrintable(rig.findings()));
    QVERIFY(!rig.findings().contains("c.input"));
  }

  void a_loop_through_an_input_that_this_tick_does_not_use_is_none() {
    Rig rig;
    const NodeId source = rig.add("Number");
    const NodeId a = rig.add("Follower", "a");
    rig.wire(source, "value", a, "input");
    rig.wire(a, "value", a, "late");
    QCOMPARE(rig.findings(), QString());
    QCOMPARE(rig.order(), QString("number a"));
  }

  void one_mistake_is_one_finding_data() {
    QTest::addColumn<QString>("mistake");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* mistake, const char* said) {
      QTest::newRow(mistake) << mistake << QString::fromUtf8(said);
    };
    row("unknown component",
        "rig.lua:4: there is no component \"Sprin\", did you mean \"Spring\"?");
    row("duplicate name",
        "rig.lua:4: \"number\" is the name of the Number at rig.lua:1: give this one another, "
        "Number { name = \"second_number\", … }");
    row("bad name",
        "rig.lua:4: name = \"2x\": needs letters, digits and underscores, starting "
        "with a letter");
    row("unknown parameter",
        "rig.lua:4: number has no parameter \"amplitud\", did you mean \"amplitude\"?");
    row("wrong unit", "rig.lua:4: number.amplitude = \"2 N\": needs m, e.g. \"1 m\" (at most 1 m)");
    row("required parameter",
        "rig.lua:4: spring needs \"stiffness\" (how hard it pushes, e.g. \"1 N/m\")");
    row("missing input", "rig.lua:4: second.input is not connected: what it follows");
    row("two drivers",
        "rig.lua:4: follower.input is driven already (at rig.lua:3): add the two "
        "with + first");
    row("unknown output", "rig.lua:4: number has no output \"valu\", did you mean \"value\"?");
    row("unknown input", "rig.lua:4: follower has no input \"inputt\", did you mean \"input\"?");
    row("no field",
        "rig.lua:4: number.value.x → follower.late: a double has no fields, \"x\" was "
        "asked for");
    row("unit", "rig.lua:5: number.value → test_device.load: [m] cannot go where [N] is needed");
    row("frame",
        "rig.lua:7: points.camera.position → spring.position: a value in frame \"camera\" "
        "cannot go where frame \"device\" is needed");
    row("type",
        "rig.lua:5: points.tip → follower.late: a PointMotion cannot go where a double is "
        "needed");
    row("rate",
        "rig.lua:4: number: 300 Hz does not divide the thread's 1000 Hz; near are 333.333 "
        "and 250 Hz");
    row("rate above", "rig.lua:4: number: 2000 Hz is not within 0 to the thread's 1000 Hz");
    row("rate negative", "rig.lua:4: number: -100 Hz is not within 0 to the thread's 1000 Hz");
    row("phase", "rig.lua:4: number: phase 4 is not within 0–3");
    row("thread rate", "a rate of 0.5 Hz: 1 Hz to 100 kHz is possible");
    row("limits", "rig.lua:4: test_device: the device does not declare its limits: axes");
    row("generic without a type",
        "rig.lua:4: generic_sum.value has no type yet: wire it to a port "
        "that has");
    row("configure", "rig.lua:4: spring: too stiff for the loop");
    row("unplaceable", "rig.lua:4: number: a Number cannot be placed at a site");
  }
  void one_mistake_is_one_finding() {
    QFETCH(QString, mistake);
    QFETCH(QString, said);
    Rig rig;
    const NodeId number = rig.add("Number");
    const NodeId follower = rig.add("Follower");
    rig.wire(number, "value", follower, "input");
    const auto spring = [&](const char* stiffness, const char* point) {
      const NodeId id = rig.add("Spring");
      if (*stiffness != 0) rig.set(id, "stiffness", stiffness);
      rig.wire(rig.add("Points"), point, id, "position");
    };
    if (mistake == "unknown component") rig.graph.add("Sprin", "", rig.here());
    if (mistake == "duplicate name") rig.graph.add("Number", "", rig.here());
    if (mistake == "bad name") rig.graph.add("Number", "2x", rig.here());
    if (mistake == "unknown parameter") rig.set(number, "amplitud", "1 m");
    if (mistake == "wrong unit") rig.set(number, "amplitude", "2 N");
    if (mistake == "required parameter") spring("", "tip.position");
    if (mistake == "missing input") rig.add("Follower", "second");
    if (mistake == "two drivers") rig.wire(number, "value", follower, "input");
    if (mistake == "unknown output") rig.wire(number, "valu", follower, "late");
    if (mistake == "unknown input") rig.wire(number, "value", follower, "inputt");
    if (mistake == "no field") rig.wire(number, "value.x", follower, "late");
    if (mistake == "unit") rig.wire(number, "value", rig.add("TestDevice"), "load");
    if (mistake == "frame") spring("1 N/m", "camera.position");
    if (mistake == "type") rig.wire(rig.add("Points"), "tip", follower, "late");
    if (mistake == "rate") rig.graph.set_rate(number, 300.0, 0, rig.here());
    if (mistake == "rate above") rig.graph.set_rate(number, 2000.0, 0, rig.here());
    if (mistake == "rate negative") rig.graph.set_rate(number, -100.0, 0, rig.here());
    if (mistake == "phase") rig.graph.set_rate(number, 250.0, 4, rig.here());
    if (mistake == "thread rate") rig.options.rate = 0.5;
    if (mistake == "limits") rig.set(rig.add("TestDevice"), "declares_limits", "false");
    if (mistake == "generic without a type") rig.add("GenericSum");
    if (mistake == "configure") spring("30 N/mm", "tip.position");
    if (mistake == "unplaceable") rig.graph.place(number, {}, rig.here());
    QCOMPARE(rig.findings(), said);
  }

  void a_dozen_mistakes_are_a_dozen_findings_of_one_report() {
    Rig rig;
    rig.graph.add("Wal", "", rig.here());
    const NodeId number = rig.add("Number");
    rig.graph.add("Number", "", rig.here());
    rig.set(number, "amplitude", "5");
    rig.set(number, "phase", "5");
    const NodeId a = rig.add("Follower", "a");
    const NodeId b = rig.add("Follower", "b");
    rig.wire(a, "value", b, "input");
    rig.wire(b, "value", a, "input");
    rig.wire(number, "value", a, "input");
    rig.add("Follower", "lonely");
    rig.wire(number, "vale", b, "late");
    const NodeId points = rig.add("Points");
    rig.wire(points, "tip", b, "late");
    rig.graph.set_rate(number, 300.0, 0, rig.here());
    rig.add("Spring");
    QCOMPARE(check(rig.graph, rig.options).all().size(), std::size_t{12});
  }

  void a_generic_component_takes_its_type_from_either_side() {
    Rig rig;
    const NodeId points = rig.add("Points");
    const NodeId sum = rig.add("GenericSum", "sum");
    const NodeId offset = rig.add("GenericConstant", "offset");
    const NodeId alone = rig.add("GenericConstant", "alone");
    rig.set(alone, "quantity", "3 N");
    rig.wire(points, "tip.position", sum, "inputs");
    rig.wire(offset, "value", sum, "inputs");
    const auto wired = trocar::wire(rig.graph, rig.options);
    const auto signature = [&](NodeId id) {
      return wired->component(id)->outputs()[0]->signature()->text();
    };
    QCOMPARE(signature(sum), std::string("Vector3 [m] in device"));
    QCOMPARE(signature(offset), std::string("Vector3 [m] in device"));
    QCOMPARE(signature(alone), std::string("double [N]"));
  }

  void generic_components_between_two_types_are_a_conflict() {
    Rig rig;
    const NodeId points = rig.add("Points");
    const NodeId number = rig.add("Number");
    const NodeId sum = rig.add("GenericSum", "sum");
    rig.wire(points, "tip.position", sum, "inputs");
    rig.wire(number, "value", sum, "inputs");
    QCOMPARE(rig.findings(),
             QString("rig.lua:5: number.value → sum.inputs: a double cannot go where a Vector3 is "
                     "needed"));
  }

  void what_only_a_simulation_knows_must_not_reach_an_effort_data() {
    QTest::addColumn<QString>("way");
    QTest::addColumn<bool>("refused");
    QTest::newRow("straight into the effort") << "straight" << true;
    QTest::newRow("through a component") << "through" << true;
    QTest::newRow("through an input that is used a tick later") << "late" << true;
    QTest::newRow("to a component beside") << "beside" << false;
    QTest::newRow("to a device's external load") << "load" << false;
    QTest::newRow("to another device's load, whose position is rendered on") << "behind" << false;
  }
  void what_only_a_simulation_knows_must_not_reach_an_effort() {
    QFETCH(QString, way);
    QFETCH(bool, refused);
    Rig rig;
    const NodeId device = rig.add("TestDevice", "arm");
    const NodeId other = rig.add("TestDevice", "other");
    const NodeId statics = rig.add("Statics");
    const NodeId follower = rig.add("Follower");
    const NodeId number = rig.add("Number");
    rig.wire(statics, "effort", device, "effort");
    rig.wire(way == "beside" ? device : number, way == "beside" ? "truth.height" : "value",
             follower, "input");
    if (way == "late") {
      rig.wire(device, "truth.height", follower, "late");
      rig.wire(follower, "value", statics, "offset");
    }
    if (way == "through") rig.wire(device, "truth.height", statics, "offset");
    const NodeId newton = rig.add("GenericSum", "newton");
    if (way == "load" || way == "behind") {
      rig.wire(device, "truth.force", way == "load" ? device : other, "load");
    }
    if (way == "behind") rig.wire(other, "position.axis1", statics, "offset");
    rig.wire(number, "value", newton, "inputs");
    if (way == "straight") rig.wire(device, "truth.effort", other, "effort");
    const QString said = rig.findings();
    QCOMPARE(said.contains("only a simulation knows arm."), refused);
    QCOMPARE(said.isEmpty(), !refused);
  }

  void the_schedule_knows_what_reaches_hold_and_effort() {
    Rig rig;
    const NodeId device = rig.add("TestDevice");
    const NodeId effort = rig.add("Statics", "rendering");
    const NodeId hold = rig.add("Statics", "gravity");
    const NodeId number = rig.add("Number");
    rig.add("Number", "idle");
    rig.wire(effort, "effort", device, "effort");
    rig.wire(hold, "effort", device, "hold");
    rig.wire(number, "value", effort, "offset");
    rig.wire(number, "value", hold, "offset");
    const auto wired = trocar::wire(rig.graph, rig.options);
    for (const ScheduleItem& item : wired->main().schedule()) {
      const std::string& name = item.component->name();
      QCOMPARE(item.reaches_effort, name == "rendering" || name == "number" ? 1u : 0u);
      QCOMPARE(item.reaches_hold, name == "gravity" || name == "number" ? 1u : 0u);
    }
  }

  void a_group_builds_its_parts_and_forwards_its_parameters() {
    Rig rig;
    const NodeId pair = rig.add("Pair");
    rig.set(pair, "amplitude", "7 mm");
    rig.graph.build_group(pair);
    const NodeId after = rig.add("Follower", "after");
    rig.graph.connect(rig.graph.node(pair).exports.outputs.at("value"), {after, "input"},
                      rig.here());
    const auto amplitude = [&] {
      const auto wired = trocar::wire(rig.graph, rig.options);
      return **dynamic_cast<Parameter<double>*>(
          wired->find("pair.source")->find_parameter("amplitude"));
    };
    QCOMPARE(rig.order(), QString("pair.source pair.end after"));
    QCOMPARE(amplitude(), 7e-3);
    rig.options.set["pair.amplitude"] = {{std::string("9 mm")}, {"--set"}};
    QCOMPARE(amplitude(), 9e-3);
    rig.options.set.clear();
    QCOMPARE(amplitude(), 7e-3);
    rig.options.set["pair.source.amplitude"] = {{std::string("4 mm")}, {"--set"}};
    QCOMPARE(amplitude(), 4e-3);
    const auto wired = trocar::wire(rig.graph, {});
    QCOMPARE(wired->followers(rig.graph, {pair, "amplitude"}).size(), std::size_t{1});
  }

  void a_parameter_follows_another_through_any_order_of_links() {
    Rig rig;
    const NodeId a = rig.add("Number", "a");
    const NodeId b = rig.add("Number", "b");
    const NodeId c = rig.add("Number", "c");
    rig.set(a, "amplitude", "7 mm");
    rig.graph.link({b, "amplitude"}, {c, "amplitude"}, rig.here());
    rig.graph.link({a, "amplitude"}, {b, "amplitude"}, rig.here());
    const auto wired = trocar::wire(rig.graph, rig.options);
    QCOMPARE(wired->find("c")->find_parameter("amplitude")->text(), std::string("0.007 m"));
  }

  void a_parameter_that_cannot_follow_another_is_a_finding() {
    Rig rig;
    const NodeId points = rig.add("Points");
    const NodeId number = rig.add("Number");
    const NodeId spring = rig.add("Spring");
    rig.wire(points, "tip.position", spring, "position");
    rig.graph.link({number, "amplitude"}, {spring, "stiffness"}, rig.here());
    QCOMPARE(rig.findings(), QString("rig.lua:5: spring.stiffness = 0.001 m: a number [m] cannot "
                                     "be a number [N/m]"));
  }

  void a_required_parameter_of_a_group_is_not_satisfied_by_an_earlier_run() {
    struct Needs : ParameterSet {
      Parameter<double> force{this, "force", {.unit = "N", .doc = "how much"}};
    };
    Rig rig;
    rig.graph.add_group(std::make_unique<Needs>(), "Needs", "", rig.here(), "");
    rig.options.set["needs.force"] = {{std::string("3 N")}, {"run"}};
    QCOMPARE(rig.findings(), QString());
    rig.options.set.clear();
    QCOMPARE(rig.findings(), QString("rig.lua:1: needs needs \"force\" (how much, e.g. \"1 N\")"));
  }

  void placing_at_a_site_wires_motion_and_force() {
    Rig rig;
    const NodeId points = rig.add("Points");
    const NodeId statics = rig.add("Statics");
    const NodeId spring = rig.add("Spring");
    rig.set(spring, "stiffness", "1 N/mm");
    Site site{{points, "tip", "position"},
              {points, "tip", "velocity"},
              InputRef{statics, "forces"},
              {},
              {}};
    rig.graph.place(spring, site, rig.here());
    QCOMPARE(rig.findings(), QString());
    QCOMPARE(rig.order(), QString("points spring statics"));
    site.force.reset();
    rig.graph.place(spring, site, rig.here());
    QVERIFY(rig.findings().contains("rig.lua:6: spring: this site takes no rendered force"));
  }

  void an_override_wins_and_one_that_names_nothing_is_a_finding() {
    Rig rig;
    rig.graph.overrides["number.amplitude"] = {{std::string("3 mm")}, {"--set"}};
    rig.graph.overrides["numbr.amplitude"] = {{std::string("3 mm")}, {"--set"}};
    const NodeId number = rig.add("Number");
    rig.set(number, "amplitude", "1 mm");
    QCOMPARE(rig.graph.node(number).component->find_parameter("amplitude")->text(),
             std::string("0.003 m"));
    rig.graph.report_unused_overrides();
    QCOMPARE(rig.findings(), QString("--set: nothing is called \"numbr.amplitude\", did you mean "
                                     "\"number.amplitude\"?"));
  }

  void a_run_sets_a_required_parameter_and_names_what_it_cannot() {
    Rig rig;
    const NodeId points = rig.add("Points");
    const NodeId spring = rig.add("Spring");
    rig.wire(points, "tip.position", spring, "position");
    rig.options.set["spring.stiffness"] = {{std::string("3 N/mm")}, {"run"}};
    QCOMPARE(rig.findings(), QString());
    rig.options.set["spring.stifness"] = {{std::string("3 N/mm")}, {"run"}};
    QCOMPARE(rig.findings(), QString("run: nothing is called \"spring.stifness\", did you mean "
                                     "\"spring.stiffness\"?"));
  }

  void memory_holds_the_numbers_first_and_in_order() {
    Rig rig;
    const NodeId number = rig.add("Number");
    const NodeId follower = rig.add("Follower");
    rig.wire(number, "value", follower, "input");
    rig.graph.set_rate(follower, 250.0, 3, rig.here());
    const auto wired = trocar::wire(rig.graph, rig.options);
    QCOMPARE(wired->main().numbers().size(), std::size_t{2});
    QCOMPARE(wired->main().schedule()[1].divider, std::int64_t{4});
    QCOMPARE(wired->main().schedule()[1].phase, std::int64_t{3});
    wired->component(number)->step({.time = 2.0});
    wired->component(follower)->step({});
    QCOMPARE(wired->main().numbers()[1], 2e-3);
    QCOMPARE(wired->main().offset_of(*wired->component(follower)->outputs()[0]), sizeof(double));
  }

  void a_long_chain_of_generic_components_is_resolved_from_either_end() {
    for (const bool backwards : {false, true}) {
      Rig rig;
      const NodeId end = backwards ? rig.add("Follower") : rig.add("Number");
      std::vector<NodeId> chain;
      for (int i = 0; i < 10000; ++i)
        chain.push_back(rig.add("GenericSum", "s" + std::to_string(i)));
      if (!backwards) rig.wire(end, "value", chain.front(), "inputs");
      for (std::size_t i = 1; i < chain.size(); ++i)
        rig.wire(chain[i - 1], "value", chain[i], "inputs");
      if (backwards) rig.wire(chain.back(), "value", end, "input");
      QCOMPARE(rig.findings(), QString());
    }
  }

  // Quadratic loops over wires would take minutes here.
  void ten_thousand_components_in_a_chain_are_wired() {
    Rig rig;
    NodeId before = rig.add("Number");
    for (int i = 0; i < 10000; ++i) {
      const NodeId next = rig.add("Follower", "f" + std::to_string(i));
      rig.wire(before, "value", next, "input");
      before = next;
    }
    QCOMPARE(trocar::wire(rig.graph, rig.options)->main().schedule().size(), std::size_t{10001});
  }

  // All are ready at once, all are fed late, and all names have the same stem.
  void ten_thousand_components_side_by_side_are_wired() {
    Rig rig;
    const NodeId source = rig.add("Number", "source");
    for (int i = 0; i < 10000; ++i) {
      const NodeId next = rig.add("Follower", rig.graph.unused_name("follower", ""));
      rig.wire(source, "value", next, "input");
      rig.wire(next, "value", next, "late");
    }
    QCOMPARE(trocar::wire(rig.graph, rig.options)->main().schedule().size(), std::size_t{10001});
  }

  void a_loop_of_ten_thousand_components_is_reported() {
    Rig rig;
    const NodeId first = rig.add("Follower", "first");
    NodeId before = first;
    for (int i = 1; i < 10000; ++i) {
      const NodeId next = rig.add("Follower", "f" + std::to_string(i));
      rig.wire(before, "value", next, "input");
      before = next;
    }
    rig.wire(before, "value", first, "input");
    QVERIFY(rig.findings().contains("a loop without a delay: first.value → f1.input"));
  }

  void the_lowest_unused_name_is_taken_also_when_it_was_given_back() {
    Rig rig;
    for (const char* name : {"sum", "sum_2", "sum_3"}) {
      QCOMPARE(rig.graph.unused_name("sum", ""), std::string(name));
      rig.add("Number", name);
    }
    QCOMPARE(rig.graph.unused_name("sum", ""), std::string("sum_4"));
    QCOMPARE(rig.graph.rename(*rig.graph.find("sum_2"), "surface", ""), std::string());
    QCOMPARE(rig.graph.unused_name("sum", ""), std::string("sum_2"));
    QCOMPARE(rig.graph.rename(*rig.graph.find("sum"), "tissue", ""), std::string());
    QCOMPARE(rig.graph.unused_name("sum", ""), std::string("sum"));
  }
};

QTEST_APPLESS_MAIN(TestWiring)
#include "tst_wiring.moc"
