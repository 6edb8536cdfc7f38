// SPDX-License-Identifier: Apache-2.0
// Components that files in Lua define: ports of every type, parameters, state, faults, logs.
#include "tests/support/law_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

const QByteArray wall =
    "return trocar.fixture {\n"
    "  parameters = { plane = { \"105 mm\" },\n"
    "    stiffness = { \"2 N/mm\", range = { \"0 N/mm\", \"5 N/mm\" } } },\n"
    "  outputs = { depth = \"m\" },\n"
    "  step = function(p, at, out)\n"
    "    out.depth = math.max(0, at.position.z - p.plane)\n"
    "    out.force:set(0, 0, -p.stiffness * out.depth)\n"
    "  end,\n"
    "}\n";
const QByteArray pushed = "local laparoscope = trocar.Laparoscope { hand = \"push\" }\n";
const QByteArray beside =
    pushed + "local law = trocar.LuaFixture { file = \"law.lua\", at = laparoscope.tip }\n";

QByteArray content(const QString& path) {
  QFile file(path);
  return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestLuaComponent : public QObject {
  Q_OBJECT

  static void sound(const LawOutcome& outcome) {
    QVERIFY2(outcome.said.isEmpty(), qPrintable(outcome.said.join('\n')));
    QVERIFY2(outcome.script.findings.isEmpty(), qPrintable(outcome.script.findings.join('\n')));
  }

 private Q_SLOTS:
  void it_does_what_a_wall_in_cpp_does() {
    sound(run_law(wall, beside +
                            "local run = trocar.run { duration = \"2 s\" }\n"
                            "local cpp = run:at(law.force.z, \"1.9 s\")\n"
                            "assert(cpp < -1, cpp)\n"
                            "assert(math.abs(cpp + 2000 * run:at(law.depth, \"1.9 s\")) < 1e-9)\n"
                            "assert(run:max(law.script.allocations) == 0)\n"
                            "assert(run:max(law.script.time) == 0)\n"));
  }

  void its_parameters_are_the_frameworks() {
    sound(run_law(wall,
                  beside +
                      "local run = trocar.run { duration = \"2 s\", set = { [\"law.plane\"] = "
                      "\"104 mm\" } }\n"
                      "local depth = run:at(law.depth, \"1.9 s\")\n"
                      "assert(math.abs(run:at(law.force.z, \"1.9 s\") + 1000 * depth) < 1e-9)\n",
                  {"law.stiffness=1 N/mm"}));
  }

  void a_live_edit_reaches_it_under_a_ramp() {
    sound(run_law(
        wall, beside +
                  "local run = trocar.run { duration = \"2 s\", edits = {\n"
                  "  { at = \"1.5 s\", [\"law.stiffness\"] = \"1 N/mm\" } } }\n"
                  "local function k(t) return -run:at(law.force.z, t) / run:at(law.depth, t) end\n"
                  "assert(math.abs(k(\"1.4 s\") - 2000) < 1e-6)\n"
                  "assert(k(\"1.6 s\") < 1999 and k(\"1.6 s\") > 1001)\n"
                  "assert(math.abs(k(\"1.9 s\") - 1000) < 1e-6)\n"));
  }

  void a_value_outside_its_range_is_refused() {
    const LawOutcome outcome = run_law(wall, beside, {"law.stiffness=9 N/mm"});
    QVERIFY(outcome.script.findings.join('\n').contains("must be within 0–5 N/mm"));
  }

  void every_type_of_port_passes() {
    const QByteArray law =
        "return trocar.component {\n"
        "  inputs = { pose = \"Pose\", q = \"Joints [m, m, m, rad, rad, rad]\",\n"
        "    jacobian = \"Jacobian of 6 axes\", free = { \"Vector3 [N]\", optional = true } },\n"
        "  outputs = { w = \"Wrench\", flag = \"bool\", count = \"int64\", j = \"Joints [m, "
        "rad]\",\n"
        "    mode = { \"Enumeration\", labels = { \"whole\", \"torn\" } }, back = \"Pose\" },\n"
        "  step = function(p, inputs, out, state, tick)\n"
        "    out.w.force:set(inputs.q[1], inputs.jacobian[1][1], inputs.free.x)\n"
        "    out.w.moment = inputs.pose.position * 2\n"
        "    out.flag, out.count, out.mode = true, 7, tick.time > 0.005 and \"torn\" or \"whole\"\n"
        "    out.j[2] = inputs.q[4]\n"
        "    out.back.position = inputs.pose.position\n"
        "    out.back.rotation.w = inputs.pose.rotation.w\n"
        "  end,\n"
        "}\n";
    sound(run_law(
        law,
        "local l = trocar.Laparoscope { hand = \"none\" }\n"
        "local law = trocar.LuaComponent { file = \"law.lua\", pose = l.tool.pose,\n"
        "  q = l.device.position, jacobian = l.tool.jacobian }\n"
        "local run = trocar.run { duration = \"0.01 s\" }\n"
        "local function same(a, b) assert(math.abs(run:last(a) - b) < 1e-12, tostring(a)) end\n"
        "same(law.w.force.x, run:last(l.device.position.axis1))\n"
        "same(law.w.force.y, run:last(l.tool.jacobian.j11))\n"
        "same(law.w.moment.z, 2 * run:last(l.tool.pose.position.z))\n"
        "same(law.back.position.z, run:last(l.tool.pose.position.z))\n"
        "same(law.back.rotation.w, run:last(l.tool.pose.rotation.w))\n"
        "same(law.j.axis2, run:last(l.device.position.axis4))\n"
        "same(law.count, 7)\n"
        "same(law.mode, 1)\n"));
  }

  void units_are_checked_like_everybody_elses() {
    const LawOutcome outcome = run_law(
        "return trocar.component { inputs = { force = \"Vector3 [N]\" }, outputs = { d = \"m\" },\n"
        "  step = function() end }",
        pushed + "trocar.LuaComponent { file = \"law.lua\", force = laparoscope.tip.position }");
    QVERIFY(outcome.script.findings.join('\n').contains("[m] cannot go where [N] is needed"));
  }

  void a_failing_law_resists_only_and_is_latched() {
    const LawOutcome outcome = run_law(
        "return trocar.fixture { state = { n = 0 },\n"
        "  step = function(p, at, out, state)\n"
        "    state.n = state.n + 1\n"
        "    out.force:set(0, 0, -3)\n"
        "    if state.n > 1500 then error(\"enough\") end\n"
        "  end }",
        beside +
            "local run = trocar.run { duration = \"2 s\" }\n"
            "assert(run.faults[1]:find(\"law at tick 1500.*law.lua:5: enough\"), run.faults[1])\n"
            "assert(run:at(law.force.z, \"1.499 s\") == -3)\n"
            "local after = run:at(law.force.z, \"1.5 s\")\n"
            "assert(after <= 0 and after > -3, after)\n"
            "assert(run:at(law.force.z, \"1.52 s\") == 0)\n");
    QVERIFY2(outcome.script.findings.isEmpty(), qPrintable(outcome.script.findings.join('\n')));
    QCOMPARE(outcome.said, QStringList{"law.lua:5: enough"});
  }

  void two_runs_give_the_same_bytes() {
    const QByteArray law =
        "return trocar.fixture { outputs = { sum = \"\" }, state = { seen = {} },\n"
        "  step = function(p, at, out, state)\n"
        "    local far = at.position + 1e-3 * at.velocity\n"
        "    out.force = -100 * (far - at.position)\n"
        "    state.seen = { a = far.x, b = far.y, [1] = math.random(), z = 1 }\n"
        "    for k, v in pairs(state.seen) do out.sum = out.sum * 0.5 + v end\n"
        "  end }";
    QTemporaryDir folder;
    const auto record = [&](const char* name) {
      const QString path = folder.filePath(name);
      sound(run_law(law, beside, {}, {.duration = 1.0, .record = path.toStdString()}));
      return content(path);
    };
    const QByteArray first = record("a.mcap");
    QVERIFY(first.size() > 10'000);
    QVERIFY(first.contains("return trocar.fixture"));  // the law itself is in the log
    QVERIFY(first == record("b.mcap"));
  }

  void what_it_allocates_is_a_signal() {
    sound(
        run_law("return trocar.fixture { step = function(p, at, out)\n"
                " out.force = -1 * at.velocity end }",
                beside + "local run = trocar.run { duration = \"1 s\" }\n"
                         "assert(run:at(law.script.allocations, \"0.5 s\") == 2)\n"
                         "assert(run:max(law.script.memory) < 300 * 1024)\n"));
  }

  void strict_mode_makes_it_an_error() {
    const LawOutcome outcome = run_law(
        "return trocar.fixture { step = function(p, at, out)\n out.force = -1 * at.velocity end }",
        beside, {"law.strict=true"});
    QVERIFY2(outcome.said.value(0).startsWith("law.lua:2: allocates memory"),
             qPrintable(outcome.said.join('\n')));
  }

  void it_runs_in_another_thread() {
    sound(run_law(
        "return trocar.component { outputs = { d = \"m\" }, step = function(p, i, out, s, tick)\n"
        " out.d = tick.dt end }",
        "local slow = trocar.thread { rate = \"100 Hz\" }\n"
        "local law = slow.LuaComponent { file = \"law.lua\" }\n"
        "local run = trocar.run { duration = \"0.1 s\" }\n"
        "assert(math.abs(run:last(law.d) - 0.01) < 1e-12)\n"));
  }
};

QTEST_GUILESS_MAIN(TestLuaComponent)
#include "tst_lua_component.moc"
