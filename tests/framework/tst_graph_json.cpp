// SPDX-License-Identifier: Apache-2.0
#include "framework/graph_json.hpp"
#include "framework/scripting/script.hpp"

#include <nlohmann/json.hpp>

#include "tests/support/script_bench.hpp"

using namespace trocar;
using namespace trocar::test;
using nlohmann::json;

namespace {

const QByteArray script =
    "local laparoscope = trocar.Laparoscope { hand = 'push', mount = { pitch = '20 deg' } }\n"
    "trocar.Wall { at = laparoscope.tip, stiffness = '2.2 N/mm' }\n"
    "local c = trocar.Constant { value = '2 N', rate = '100 Hz', phase = 3 }\n"
    "trocar.Scale { name = 'half', input = c.value, factor = 0.5 }\n";

const json& named(const json& list, const std::string& name, const char* key = "name") {
  static const json none;
  for (const json& each : list)
    if (each[key] == name) return each;
  return none;
}

}  // namespace

#define COMPARE_JSON(found, wanted) QCOMPARE((found).dump(), json(wanted).dump())

class TestGraphJson : public QObject {
  Q_OBJECT

  ScriptOutcome outcome_;
  json all_;

  const json& node(const char* name) { return named(all_["nodes"], name); }

 private Q_SLOTS:
  void initTestCase() {
    outcome_ = run_script_text(script, {}, {.check_only = true});
    QCOMPARE(outcome_.findings, QStringList());
    const Graph& graph = outcome_.session->graph();
    all_ = json::parse(graph_json(graph, wire(graph, {}).get()));
  }

  void a_node_says_what_it_is_and_where() {
    const json& device = node("laparoscope.device");
    COMPARE_JSON(device["type"], "SimulatedLaparoscope");
    COMPARE_JSON(device["category"], "devices");
    QVERIFY(!device["doc"].get<std::string>().empty());
    COMPARE_JSON(device["group"], "laparoscope");
    COMPARE_JSON(device["device"], true);
    QVERIFY(node("wall")["group"].is_null());
    COMPARE_JSON(node("wall")["device"], false);
  }
  void a_rate_is_a_number_or_the_threads() {
    COMPARE_JSON(node("constant")["rate"], 100.0);
    COMPARE_JSON(node("constant")["phase"], 3);
    QVERIFY(node("wall")["rate"].is_null());
  }
  void a_parameter_has_its_value_in_words_and_in_si() {
    const json& stiffness = named(node("wall")["parameters"], "stiffness");
    COMPARE_JSON(stiffness["value"], "2.2 N/mm");
    COMPARE_JSON(stiffness["si"], json({2200.0}));
    COMPARE_JSON(stiffness["range"], "0–50 N/mm");
    COMPARE_JSON(stiffness["live"], true);
    QVERIFY(!stiffness["doc"].get<std::string>().empty());
  }
  void a_parameter_that_follows_has_the_value_that_it_follows() {
    const json& mount = named(node("laparoscope.weight")["parameters"], "mount");
    COMPARE_JSON(mount["follows"], "laparoscope.mount");
    QVERIFY(mount["value"].get<std::string>().find("20 deg") != std::string::npos);
  }
  void ports_have_type_unit_frame_and_doc() {
    const json& position = named(node("laparoscope.device")["outputs"], "position");
    COMPARE_JSON(position["type"], "Joints");
    COMPARE_JSON(position["axes"], 6);
    COMPARE_JSON(position["unit"], "m, m, m, rad, rad, rad");
    const json& force = named(node("wall")["outputs"], "force");
    COMPARE_JSON(force["frame"], "device");
    QVERIFY(!force["doc"].get<std::string>().empty());
    COMPARE_JSON(named(node("laparoscope.device")["inputs"], "hold")["feedthrough"], false);
  }
  void a_generic_port_has_the_type_that_the_wiring_gave_it() {
    COMPARE_JSON(named(node("half")["outputs"], "value")["unit"], "N");
  }
  void a_wire_names_its_ends_whole_and_in_parts() {
    const json& wire = named(all_["wires"], "wall.position", "to");
    COMPARE_JSON(wire["from"], "laparoscope.tool.tip.position");
    COMPARE_JSON(wire["source"],
                 json({{"node", "laparoscope.tool"}, {"output", "tip"}, {"field", "position"}}));
    COMPARE_JSON(wire["target"], json({{"node", "wall"}, {"input", "position"}}));
    COMPARE_JSON(wire["type"], "Vector3");
    COMPARE_JSON(wire["unit"], "m");
    COMPARE_JSON(wire["frame"], "device");
    COMPARE_JSON(wire["feedthrough"], true);
    COMPARE_JSON(named(all_["wires"], "laparoscope.device.effort", "to")["feedthrough"], false);
  }
  void a_group_says_what_it_exports() {
    const json& group = named(all_["groups"], "laparoscope");
    COMPARE_JSON(group["type"], "Laparoscope");
    COMPARE_JSON(group["outputs"]["pose"], "laparoscope.tool.pose");
    COMPARE_JSON(group["parts"]["tool"], "laparoscope.tool");
    COMPARE_JSON(group["sites"]["tip"]["force"], "laparoscope.statics.tip_force");
    COMPARE_JSON(named(group["parameters"], "hand")["value"], "\"push\"");
  }
  void a_graph_that_is_not_sound_is_told_as_far_as_it_goes() {
    const ScriptOutcome broken =
        run_script_text("local c = trocar.Constant {}\ntrocar.Scale { input = c.value.x }\n", {},
                        {.check_only = true});
    QVERIFY(!broken.findings.isEmpty());
    const json told = json::parse(graph_json(broken.session->graph(), nullptr));
    COMPARE_JSON(told["wires"][0]["type"], "any");
    QVERIFY(named(told["nodes"][0]["parameters"], "value")["value"].is_null());
  }
};

QTEST_GUILESS_MAIN(TestGraphJson)
#include "tst_graph_json.moc"
