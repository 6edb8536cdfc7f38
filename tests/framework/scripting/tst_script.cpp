// SPDX-License-Identifier: Apache-2.0
// The face of Trocar: what scripts may say, and what they are told when they say it wrong. Scripts
// that are right judge themselves with assert().
#include "framework/scripting/script.hpp"

#include <QDir>

#include "framework/recording/mcap_reader.hpp"
#include "tests/support/script_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

const QByteArray device = "local laparoscope = trocar.Laparoscope { hand = \"none\" }\n";
const QByteArray wall = device + "local wall = trocar.Wall { at = laparoscope.tip }\n";
const QByteArray two =
    "local two = trocar.Constant { value = \"2 N\" }\n"
    "local three = trocar.Constant { name = \"three\", value = \"3 N\" }\n";
const QByteArray rig =
    "local Rig = trocar.group { name = \"Rig\", inputs = { \"input\" }, outputs = { \"value\" },\n"
    "  parameters = { factor = { \"2\", range = { \"0\", \"5\" } }, site = { \"tip\" } },\n"
    "  build = function(p, i)\n"
    "    local inner = trocar.Scale { name = \"inner\", input = i.input, factor = p.factor }\n"
    "    return { value = inner.value } end }\n";
const QByteArray threads =
    "local fast = trocar.thread { rate = \"1 kHz\" }\n"
    "local slow = trocar.thread { rate = \"100 Hz\", priority = 40 }\n"
    "local laparoscope = fast.Laparoscope { hand = \"none\" }\n"
    "local wall = fast.Wall { at = laparoscope.tip }\n";
const QByteArray ramp = "local sine = trocar.Sine { amplitude = \"2 N\", frequency = \"1 Hz\" }\n";

}  // namespace

class TestScript : public QObject {
  Q_OBJECT

  static void columns() {
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<QStringList>("settings");
    QTest::addColumn<QStringList>("findings");
  }
  static void row(const char* name, const QByteArray& script, const QStringList& findings = {},
                  const QStringList& settings = {}) {
    QTest::newRow(name) << script << settings << findings;
  }
  static void judge() {
    QFETCH(QByteArray, script);
    QFETCH(QStringList, settings);
    QFETCH(QStringList, findings);
    const ScriptOutcome outcome = run_script_text(script, settings);
    QVERIFY2(match(outcome.findings, findings),
             qPrintable("found:\n" + outcome.findings.join('\n') + "\nexpected:\n" +
                        findings.join('\n')));
  }

 private Q_SLOTS:
  void constructing_data() {
    columns();
    row("a component takes the name of its type",
        "local c = trocar.Constant { value = 1 }\nassert(tostring(c) == 'the component constant')");
    row("a second one needs a name", "trocar.Constant { value = 1 }\ntrocar.Constant { value = 2 }",
        {"2: \"constant\" is the name of the Constant at"});
    row("with one it is fine",
        "trocar.Constant { value = 1 }\ntrocar.Constant { name = \"other\", value = 2 }");
    row("a name is letters, digits and underscores",
        "trocar.Constant { name = \"no name\", value = 2 }", {"1: name = \"no name\": needs"});
    row("a name is a text", "trocar.Constant { name = 5, value = 2 }", {"1: name = 5: needs a"});
    row("a spec", "describe(\"wall\", function() end)", {"1: describe is for specs: run them by"});
    row("an unknown type comes with the nearest", "trocar.Wal {}",
        {"1: there is no trocar.Wal, did you mean \"Wall\"?"});
    row("an unknown key comes with the nearest",
        wall + "trocar.Wall { name = \"w\", at = laparoscope.tip, stifness = \"1 N/mm\" }",
        {"3: w (a Wall) has no input or parameter \"stifness\", did you mean \"stiffness\"?"});
    row("a key that is no text is refused",
        "trocar.Constant { value = 1, [7] = 2 }\ntrocar.Constant { name = \"b\", value = 1, [1.5] "
        "= 3 }",
        {"1: entry [7]", "2: entry [1.5]"});
    row("an argument that is no table", "trocar.Constant(3)", {"1: Constant takes one table"});
    row("a wrong unit names the right one",
        wall + "trocar.Wall { name = \"w\", at = laparoscope.tip, stiffness = \"2.2 N\" }",
        {"3: w.stiffness = \"2.2 N\": needs N/m, e.g. \"2.2 N/mm\" (0–50 N/mm)"});
    row("a bare number where a unit is needed",
        wall + "trocar.Wall { name = \"w\", at = laparoscope.tip, stiffness = 2 }",
        {"3: w.stiffness = 2: needs"});
    row("zero needs no unit",
        wall + "trocar.Wall { name = \"w\", at = laparoscope.tip, stiffness = 0 }");
    row("a value out of range",
        wall + "trocar.Wall { name = \"w\", at = laparoscope.tip, stiffness = \"99 N/mm\" }",
        {"3: w.stiffness = \"99 N/mm\": must be within 0–50 N/mm"});
    row("a choice that does not exist", "trocar.Laparoscope { hand = \"pusg\" }",
        {"1: laparoscope.hand = \"pusg\": needs one of \"none\", \"relaxed\", \"firm\", \"push\", "
         "did you "
         "mean"});
    row("a parameter that is needed", "trocar.Constant {}", {"1: constant needs \"value\""});
    row("members cannot be assigned to", wall + "wall.stiffness = \"1 N/mm\"",
        {"3: the component wall cannot be assigned to"});
  }
  void constructing() { judge(); }

  void wiring_data() {
    columns();
    row("at wires a fixture to a site", wall);
    row("at is a site", device + "trocar.Wall { at = laparoscope }",
        {"2: wall: at = the component laparoscope is no site"});
    row("a site that does not exist makes one finding",
        device + "trocar.Wall { at = laparoscope.tipp }",
        {"2: laparoscope (a Laparoscope) has no \"tipp\", did you mean \"tip\"?"});
    row("a component that cannot be placed",
        device + "trocar.Constant { value = 1, at = laparoscope.tip }",
        {"2: constant: a Constant cannot be placed at a site"});
    row("a fixture without a site lacks its inputs", "trocar.Wall {}",
        {"1: wall.position is not connected", "1: wall.velocity is not connected"});
    row("forces at a site add",
        wall +
            "trocar.Spring { at = laparoscope.tip }\n"
            "trocar.Staircase { at = laparoscope.incision, axis = \"x\", peak = \"1 N\" }");
    row("to fans out and returns the output",
        two +
            "local a = trocar.Scale { name = \"a\", factor = 2 }\n"
            "local b = trocar.Scale { name = \"b\", factor = 3 }\n"
            "assert(two.value:to(a.input, b.input):to() == nil or true)",
        {"5: constant.value:to(): to which input?"});
    row("two drivers of an input",
        two +
            "local a = trocar.Scale { name = \"a\", factor = 2, input = two.value }\n"
            "three.value:to(a.input)",
        {"4: a.input is driven already"});
    row("a literal to an input becomes a constant",
        "local a = trocar.Scale { factor = 2, input = \"3 N\" }\n"
        "local run = trocar.run { duration = \"5 ms\" }\n"
        "assert(run:last(a.value) == 6 and run:last(\"scale.input.value\") == 3)");
    row("a list goes to an input that takes several",
        two +
            "local s = trocar.Sum { terms = { two.value, three.value, \"1 N\", \"2 N\" } }\n"
            "assert(trocar.run { duration = \"5 ms\" }:last(s.value) == 8)");
    row("a parameter follows another",
        "local a = trocar.SimulatedLaparoscope { mount = { pitch = \"20 deg\" }, hand = \"none\" "
        "}\n"
        "local g = trocar.GravityCompensation { position = a.position, mount = a.mount }\n"
        "g.effort:to(a.hold)");
    row("a parameter does not follow one of another kind",
        device + "trocar.Wall { at = laparoscope.tip, stiffness = laparoscope.hand }",
        {"2: wall.stiffness = \"none\": a choice"});
    row("fields of an output are outputs",
        wall +
            "local s = trocar.Scale { input = wall.force.z, factor = 2 }\n"
            "trocar.run { duration = \"5 ms\" }");
    row("a field that does not exist", wall + "local s = wall.force.w",
        {"3: wall.force: a Vector3 has no field \"w\", known are x, y, z"});
    row("types must agree", wall + "local s = wall.force + wall.depth",
        {"3: wall.depth → sum.terms: a double cannot go where a Vector3 is needed"});
    row("a component may run slower",
        two + "trocar.Scale { input = two.value, factor = 2, rate = \"100 Hz\", phase = 3 }");
    row("a rate that does not divide",
        two + "trocar.Scale { input = two.value, factor = 2, rate = \"300 Hz\" }",
        {"3: scale: 300 Hz does not divide"});
    row("a rate needs Hz",
        two + "trocar.Scale { input = two.value, factor = 2, rate = 300, phase = \"x\" }",
        {"3: scale.phase = \"x\": needs a whole number", "3: scale.rate = 300: needs Hz"});
    row("a rate of nothing",
        two + "trocar.Scale { input = two.value, factor = 2, rate = \"0 Hz\" }",
        {"3: scale.rate = \"0 Hz\": needs Hz, above 0"});
    row("a loop is refused with its path",
        "local a = trocar.Sum { name = \"a\", terms = { \"1 N\" } }\n"
        "local b = trocar.Scale { name = \"b\", input = a.value, factor = 2 }\n"
        "b.value:to(a.terms)",
        {"3: a loop without a delay: a.value → b.input, b.value → a.terms"});
    row("a delay makes it one that runs",
        "local a = trocar.Sum { name = \"a\", terms = { \"1 N\" } }\n"
        "a.value:delay { initial = \"0 N\" }:to(a.terms)\n"
        "assert(trocar.run { duration = \"5 ms\" }:last(a.value) == 5)");
    row("two delays need no names",
        two +
            "local a = two.value:delay { initial = \"0 N\" }:delay { initial = \"9 N\" }:as \"a\"\n"
            "local run = trocar.run { duration = \"5 ms\" }\n"
            "assert(run:first(a) == 9 and run:last(\"a.value\") == 2)");
  }
  void wiring() { judge(); }

  void arithmetic_data() {
    columns();
    const QByteArray run = "local run = trocar.run { duration = \"5 ms\" }\n";
    row("outputs add, subtract, scale and multiply",
        two +
            "local a, b, c, d, e = two.value + three.value, two.value - three.value,\n"
            "  2 * three.value, two.value * three.value, -two.value\n" +
            run +
            "assert(run:last(a) == 5 and run:last(b) == -1 and run:last(c) == 6)\n"
            "assert(run:last(d) == 6 and run:last(e) == -2)");
    row("with a literal", two + "local a, b = two.value + \"1 N\", \"1 N\" - two.value\n" + run +
                              "assert(run:last(a) == 3 and run:last(b) == -1)");
    row("as names what they make", two + "local a = (two.value + three.value):as \"total\"\n" +
                                       run + "assert(run:last(\"total.value\") == 5)");
    row("as refuses a name that is taken", two + "local a = (two.value + three.value):as \"three\"",
        {"3: \"three\" is the name of something else already"});
    row("as refuses its own name twice",
        two + "local a = (two.value + three.value):as \"a\"\nlocal b = (a + a):as \"a\"",
        {"4: \"a\" is the name of something else already"});
    row("as does not rename a component", two + "local a = two.value:as \"a\"",
        {"3: constant.value has a name already"});
    row("units must agree", two + "local a = two.value + \"1 mm\"", {"3: sum"});
    row("a component is no output", two + "local a = two.value + three",
        {"3: sum.terms is an input: it takes an output or a value, not the component three"});
  }
  void arithmetic() { judge(); }

  void settings_data() {
    columns();
    const QByteArray read = wall + "assert(true)\n";
    row("--set wins over the script",
        two +
            "local a = trocar.Scale { input = two.value, factor = 2 }\n"
            "assert(trocar.run { duration = \"5 ms\" }:last(a.value) == 8)",
        {}, {"scale.factor=4"});
    row("--set without a dot is an argument",
        "assert(trocar.args.subject == 7 and trocar.args.who == nil and trocar.args.on == true)",
        {}, {"subject=7", "on=true"});
    row("one that nobody used", read, {"--set: nothing is called \"wall.stifness\", did you mean"},
        {"wall.stifness=1 N/mm"});
    row("an argument that nobody used", "local a = trocar.args.subject",
        {"--set: the script never asks for trocar.args.subjet, did you mean \"subject\"?"},
        {"subjet=7"});
    row("a wrong unit", read, {"--set: wall.stiffness = \"1 N\": needs N/m"},
        {"wall.stiffness=1 N"});
    row("set of a run wins over the constructor",
        two +
            "local a = trocar.Scale { input = two.value, factor = 2 }\n"
            "for _, f in ipairs { 3, 5 } do\n"
            "  local r = trocar.run { duration = \"5 ms\", set = { [\"scale.factor\"] = f } }\n"
            "  assert(r:last(a.value) == 2 * f) end\n"
            "assert(trocar.run { duration = \"5 ms\" }:last(a.value) == 4)");
    row("--set wins over set of a run",
        two +
            "local a = trocar.Scale { input = two.value, factor = 2 }\n"
            "assert(trocar.run { duration = \"5 ms\", set = { [\"scale.factor\"] = 3 } }\n"
            "  :last(a.value) == 14)",
        {}, {"scale.factor=7"});
    row("set of a run names what exists",
        two + "trocar.run { duration = \"5 ms\", set = { [\"constant.valu\"] = 3 } }",
        {"3: nothing is called \"constant.valu\", did you mean \"constant.value\"?"});
  }
  void settings() { judge(); }

  void groups_data() {
    columns();
    const QByteArray run = "local run = trocar.run { duration = \"5 ms\" }\n";
    row("a group is used like a component",
        rig + "local r = Rig { input = \"3 N\", factor = 4 }\n" + run +
            "assert(run:last(r.value) == 12 and run:last(\"rig.inner.value\") == 12)");
    row("its parameters have defaults",
        rig + "local r = Rig { input = \"3 N\" }\n" + run + "assert(run:last(r.value) == 6)");
    row("and ranges", rig + "Rig { input = \"3 N\", factor = 9 }", {"6: rig.factor = 9: must be"});
    row("--set reaches them",
        rig + "local r = Rig { input = \"3 N\" }\n" + run + "assert(run:last(r.value) == 9)", {},
        {"rig.factor=3"});
    row("--set reaches its parts",
        rig + "local r = Rig { input = \"3 N\" }\n" + run + "assert(run:last(r.value) == 15)", {},
        {"rig.inner.factor=5"});
    row("an input that is missing", rig + "Rig {}", {"6: rig needs its input \"input\""});
    row("an unknown key", rig + "Rig { input = \"3 N\", facter = 2 }",
        {"6: rig has no input or parameter \"facter\", did you mean \"factor\"?"});
    row("two of them need names",
        rig +
            "Rig { input = \"3 N\" }\nRig { name = \"b\", input = \"3 N\" }\n"
            "Rig { input = \"1 N\" }",
        {"8: \"rig\" is the name of the group at"});
    row("groups nest",
        rig +
            "local Outer = trocar.group { name = \"Outer\", build = function()\n"
            "  return { value = Rig { input = \"1 N\" }.value } end }\n"
            "local o = Outer {}\n" +
            run + "assert(run:last(o.value) == 2 and run:last(\"outer.rig.inner.value\") == 2)");
    row("sites come out of a group",
        "local G = trocar.group { name = \"Rig\", build = function()\n"
        "  return { tip = trocar.Laparoscope { hand = \"none\" }.tip } end }\n"
        "trocar.Wall { at = G {}.tip }");
    row("an output that build does not return",
        "trocar.group { outputs = { \"x\" }, build = function() end } {}",
        {"1: group: build did not return the output \"x\""});
    row("build asks for what is not declared",
        "trocar.group { parameters = { factor = { 1 } }, build = function(p, i)\n"
        "  local a, b = p.facter, i.input end } {}",
        {"2: the group has no parameter \"facter\", did you mean \"factor\"?",
         "2: the group has no input \"input\""});
    row("build returns what cannot be used",
        "trocar.group { build = function() return { y = 3 } end } {}",
        {"1: group: build returned \"y\", which is no output"});
    row("an error inside build has its line",
        "local G = trocar.group { build = function()\n  local x = nil + 1 end }\nG {}",
        {"2: attempt to perform arithmetic on a nil value"});
    row("a group without build", "trocar.group { parameters = {} }",
        {"1: trocar.group needs build = function"});
    row("a misspelt field of group", "trocar.group { biuld = 1, build = function() end }",
        {"1: trocar.group has no \"biuld\", did you mean \"build\"?"});
    row("a group that builds itself without end",
        "local G\nG = trocar.group { build = function() G {} end }\nG {}", {": C stack overflow"});
  }
  void groups() { judge(); }

  void running_data() {
    columns();
    row("a result computes",
        ramp +
            "local run = trocar.run { rate = \"1 kHz\", duration = \"1 s\", seed = 3 }\n"
            "local s = sine.value\n"
            "local function near(a, b) assert(math.abs(a - b) < 1e-3, a .. \" is not \" .. b) end\n"
            "near(run:mean(s), 0) near(run:rms(s), math.sqrt(2)) near(run:max(s), 2)\n"
            "near(run:min(s), -2) near(run:first(s), 0) near(run:at(s, \"0.25 s\"), 2)\n"
            "near(run:at(s, 0), 0) near(run:drift(s), 2)\n"
            "assert(run.ticks == 1000 and run.rate == 1000 and #run.faults == 0)\n"
            "near(run.duration, 1)");
    row("fit gives a line",
        ramp +
            "local double = 2 * sine.value + \"1 N\"\n"
            "local line = trocar.run { duration = \"1 s\" }:fit { x = sine.value, y = double,\n"
            "  from = \"0.1 s\", to = \"0.5 s\" }\n"
            "assert(math.abs(line.slope - 2) < 1e-9 and math.abs(line.offset - 1) < 1e-9)\n"
            "assert(line.r2 > 0.999999 and line.count == 401)");
    row("an edit moves a parameter while it runs",
        wall +
            "local run = trocar.run { duration = \"0.2 s\",\n"
            "  edits = { { at = \"0.1 s\", [\"wall.stiffness\"] = \"1 N/mm\" } } }");
    row("an edit of what does not exist",
        wall +
            "trocar.run { duration = \"0.2 s\", edits = { { at = 0, [\"wall.stifness\"] = 1 } } }",
        {"3: nothing is called \"wall.stifness\", did you mean \"wall.stiffness\"?"});
    row("an edit without a time",
        wall + "trocar.run { edits = { { [\"wall.stiffness\"] = \"1 N/mm\" } } }",
        {"3: edits: each needs at"});
    row("an unknown signal comes with the nearest",
        two + "trocar.run { duration = \"5 ms\" }:mean(\"three.valeu\")",
        {"3: the run has no signal \"three.valeu\", did you mean \"three.value\"?"});
    row("a vector where a number is needed",
        wall + "trocar.run { duration = \"5 ms\" }:mean(wall.force)",
        {"3: \"wall.force\" has 3 numbers: name one of them, e.g. \"wall.force.x\""});
    row("a method that does not exist", "local r = trocar.run { duration = \"5 ms\" }:maen(\"x\")",
        {"1: a run has no \"maen\", did you mean \"mean\"?"});
    row("a method called with a dot", "trocar.run { duration = \"5 ms\" }.mean(3)",
        {"1: a method is called with a colon: run:mean(wall.load)"});
    row("fit takes a table", "trocar.run { duration = \"5 ms\" }:fit(3)", {"1: a table is needed"});
    row("run takes a table", "trocar.run \"5 s\"", {"1: trocar.run takes one table"});
    row("run has no such key", "trocar.run { duraton = \"5 s\" }",
        {"1: trocar.run has no \"duraton\", did you mean \"duration\"?"});
    row("a duration needs its unit", "trocar.run { duration = 5 }",
        {"1: duration = 5: needs s, e.g. \"1 s\""});
    row("a negative duration", "trocar.run { duration = \"-5 s\" }",
        {"1: duration = -5: 10 µs to"});
    row("a rate that no machine keeps", "trocar.run { rate = \"1 MHz\" }",
        {"1: rate = 1e+06: 1 Hz"});
    row("a seed is a whole number", "trocar.run { seed = 1.5 }", {"1: seed = 1.5: needs a whole"});
    row("a run of a broken graph tells all",
        "trocar.Wal {}\ntrocar.Constant {}\ntrocar.run { duration = \"5 ms\" }\nerror(\"not "
        "here\")",
        {"1: there is no trocar.Wal", "2: constant needs \"value\""});
    row("pcall round a run of a broken graph hides nothing",
        "trocar.Wal {}\nlocal ok = pcall(trocar.run, { duration = \"5 ms\" })\nassert(not ok)\n"
        "error(\"a second mistake\")",
        {"1: there is no trocar.Wal", "4: a second mistake"});
    row("publish takes a name and a table", "trocar.publish(\"x\", 3)",
        {"1: trocar.publish takes a name and a table"});
    row("what has no value of its own is not published", "trocar.publish(\"x\", { a = { print } })",
        {"1: publish: \"a.1\" is a function"});
    row("the name is one", "trocar.publish(\"no name\", {})", {"1: publish(\"no name\"): needs a"});
  }
  void running() { judge(); }

  void mistakes_data() {
    columns();
    row("an empty script runs", "");
    row("a comment too", "-- nothing\n");
    row("a variable that does not exist, and what follows from it",
        wall +
            "local x = laparoscop.tip.position:to(3) + walll * 2\n"
            "for _ in ipairs(x) do end for _ in pairs(x) do end assert(#x == 0 and not (x < 3))\n"
            "trocar.Wall { name = \"w\", at = x, stiffness = x, offset = x.y, rate = x }",
        {"3: there is no variable \"laparoscop\", did you mean \"laparoscope\"?",
         "3: there is no variable \"walll\", did you mean \"wall\"?"});
    row("arithmetic on nil", "local x\nprint(x + 1)",
        {"2: attempt to perform arithmetic on a nil"});
    row("error with a text", "\nerror(\"too soft\")", {"2: too soft"});
    row("error with a table", "\nerror { code = 3 }", {"2: error {code = 3}"});
    row("error with a table that has a text",
        "error(setmetatable({}, { __tostring = function() return \"soft\" end }))", {"1: soft"});
    row("error with nothing", "\nerror()", {"2: error nil"});
    row("a syntax error", "local x = = 3", {"1: unexpected symbol near '='"});
    row("a binary chunk", "\x1bLua", {": attempt to load a binary chunk"});
    row("recursion without end", "local function f() return 1 + f() end\nf()",
        {"1: stack overflow"});
    row("a string that is too long", "local s = string.rep(\"x\", 1 << 40)",
        {"1: resulting string too large"});
    row("a name that is too long",
        "trocar.Constant { [string.rep(\"x\", 1 << 20)] = 1, value = 1 }",
        {"1: constant (a Constant) has no input or parameter \"xxx"});
    row("a table that holds itself",
        wall +
            "local t = {}\nt[1], t.x = t, t\ntrocar.Logger { signals = t }\n"
            "trocar.Wall { name = \"w\", at = laparoscope.tip, point = t }",
        {"6: w.point = "});
    row("a dot instead of a colon", wall + "wall.force.to(wall.offset)",
        {"3: a method is called with a colon: wall.force:to(input)"});
    row("as with a dot", wall + "wall.force.as(\"x\")", {"3: a method is called with a colon"});
    row("delay with a dot", wall + "wall.force.delay {}", {"3: a method is called with a colon"});
    row("delay without a table", wall + "wall.force:delay(3)", {"3: delay needs a table"});
    row("to something else", wall + "wall.force:to(\"x\")", {"3: wall.force:to(x): an input is"});
    row("to a component", wall + "wall.force:to(wall)", {"3: an input is needed"});
    row("metatables are out of reach",
        wall +
            "assert(getmetatable(wall) == false and rawget(_G, \"debug\") == "
            "nil)\nrequire(\"debug\")",
        {"4: module 'debug' not found"});
    row("a truth of the simulation",
        device +
            "local z = laparoscope.device.truth.tip.position.z\n"
            "local run = trocar.run { duration = \"5 ms\" }\n"
            "assert(run:last(z) == run:last(\"laparoscope.device.truth.tip.position.z\"))");
    row("a truth that there is not", device + "local z = laparoscope.device.truth.tipp",
        {"2: (a SimulatedLaparoscope) has no \"truth.tipp\", did you mean \"truth.tip\""});
    row("a value that crosses without a word", threads + "slow.Creep { load = wall.load }",
        {"5: wall.load → creep.load goes from thread fast to thread slow: say how, by "
         "wall.load:latest { stale = \"3 ms\" }"});
    row("two threads", threads +
                           "slow.Creep { load = wall.load:latest { stale = \"5 ms\" } }\n"
                           "local run = trocar.run { duration = \"50 ms\" }\n"
                           "assert(run:last(\"creep.load_valid\") == 1)");
    row("a thread by its entry",
        threads + "trocar.Creep { thread = slow, load = wall.load:latest() }");
    row("a group of a script in a thread",
        threads +
            "local Pair = trocar.group { inputs = { \"load\" }, build = function(p, i)\n"
            "  return { depth = trocar.Creep { load = i.load }.depth } end }\n"
            "Pair { thread = slow, load = wall.load:latest() }");
    row("threads are named after their variables",
        threads + "slow.Creep { load = wall.load:latest { size = 3 } }",
        {"5: latest has no \"size\""});
    row("a thread that is none", threads + "trocar.Creep { thread = wall, load = \"1 N\" }",
        {"5: thread = \"the component wall\": needs what trocar.thread returned"});
    row("a component that there is not, in a thread", threads + "slow.Crep {}",
        {"5: there is no component \"Crep\", did you mean \"Creep\"?"});
    row("a thread without a rate", "trocar.thread {}", {"1: trocar.thread needs a rate"});
    row("a thread's misspelt entry", "trocar.thread { rat = \"1 kHz\" }",
        {"1: trocar.thread has no \"rat\", did you mean \"rate\"?"});
    row("a thread's rate in the wrong unit", "trocar.thread { rate = \"1 s\" }",
        {"1: thread.rate = \"1 s\": needs Hz"});
    row("a thread's priority", "trocar.thread { rate = \"1 kHz\", priority = 99 }",
        {"1: thread thread: priority = 99: 1 to 98 is possible"});
    row("a name that two threads want",
        "trocar.thread { name = \"a\", rate = \"1 Hz\" }\ntrocar.thread { name = \"a\", rate = \"1 "
        "Hz\" }",
        {"2: there is a thread \"a\" already"});
    row("a sum in no thread", threads + "local s = wall.load:latest() + wall.load:latest()",
        {"5: in which thread is this sum to be?"});
    row("a delay behind a crossing", threads + "wall.load:latest():delay { initial = \"0 N\" }",
        {"5: wall.load: delay it first, and let latest come last"});
    row("fit across threads",
        threads +
            "local c = slow.Creep { load = wall.load:latest() }\n"
            "trocar.run { duration = \"50 ms\" }:fit { x = wall.load, y = c.depth }",
        {"6: run:fit: the signals are of different threads"});
    row("os.exit", "os.exit(0)", {"1: os.exit would leave half a log"});
    row("work after an error that was caught",
        wall +
            "local ok = pcall(function() wall.force.to(1) end)\nassert(not ok)\n"
            "local c = coroutine.wrap(function() return wall.force.z * 2 end)()\n"
            "trocar.run { duration = \"5 ms\" }:mean(c)");
    row("pairs has an order",
        "local t, s = { b = 1, a = 2, 7, 8, c = 3 }, \"\"\n"
        "for k in pairs(t) do s = s .. k end\nassert(s == \"12abc\", s)");
    row("next goes in the same order, and a loop may clear what it visits",
        "local t = { c = 1, a = 1, b = 1, 1, 1, [true] = 1 }\nlocal s = \"\"\n"
        "for k in next, t do s = s .. tostring(k) t[k] = nil end\n"
        "assert(s == \"12abctrue\" and next(t) == nil, s)");
    row("three mistakes are three findings", "trocar.Wal {}\ntrocar.Foo {}\nlocal x = nil + 1",
        {"1: trocar.Wal", "2: trocar.Foo", "3: attempt to perform arithmetic"});
  }
  void mistakes() { judge(); }

  void a_file_that_is_no_script_is_a_finding() {
    const QTemporaryDir folder;
    for (const QString& path : {folder.path(), folder.filePath("none.lua")})
      QCOMPARE(run_script_file(path).findings,
               QStringList(path + ": there is no script that can be read"));
  }

  void what_a_script_requires_belongs_to_its_log() {
    const QTemporaryDir folder;
    const auto write = [&](const char* name, const QByteArray& text) {
      QFile file(folder.filePath(name));
      QVERIFY(file.open(QFile::WriteOnly) && file.write(text) == text.size());
    };
    QDir(folder.path()).mkdir("parts");
    write("parts/force.lua", "return \"2 N\"");
    write("late.lua", "return 1");
    write("broken.lua", "return (");
    write("script.lua",
          "trocar.Constant { value = require(\"parts.force\") }\n"
          "trocar.run { duration = \"5 ms\" }\n"
          "assert(require(\"late\") == 1 and not pcall(require, \"broken\"))\n"
          "require(\"nowhere\")");
    const std::string log = folder.filePath("log.mcap").toStdString();
    const ScriptOutcome outcome =
        run_script_file(folder.filePath("script.lua"), {}, {.record = log});
    QVERIFY2(match(outcome.findings, {"4: module 'nowhere' not found"}),
             qPrintable(outcome.findings.join('\n')));
    const McapReader reader(log);
    QStringList attached;
    for (const auto& one : reader.attachments()) attached << QString::fromStdString(one.name);
    QCOMPARE(attached,
             QStringList({"script.lua", "parts/force.lua", "graph.json", "run1.json", "late.lua"}));
  }

  void ten_mistakes_are_ten_findings() {
    const QStringList found =
        run_script_file(TROCAR_SOURCE_DIR "/tests/data/ten_mistakes.lua").findings;
    const QStringList expected = {
        "5: wall (a Wall) has no input or parameter \"stifness\", did you mean \"stiffness\"?",
        "6: soft.stiffness = \"2.2 N\": needs N/m, e.g. \"2.2 N/mm\" (0–50 N/mm)",
        "7: hard.stiffness = \"900 N/mm\": must be within 0–50 N/mm",
        "8: \"wall\" is the name of the Wall at " TROCAR_SOURCE_DIR
        "/tests/data/ten_mistakes.lua:5: give this one another, Wall { name = \"second_wall\", … }",
        "9: there is no variable \"laparoscop\", did you mean \"laparoscope\"?",
        "10: there is no trocar.Srping, did you mean \"Spring\"?",
        "11: laparoscope (a Laparoscope) has no \"tipp\", did you mean \"tip\"?",
        "12: wall.depth → sum.terms: a double cannot go where a Vector3 is needed",
        "13: wall.offset is driven already (at " TROCAR_SOURCE_DIR
        "/tests/data/ten_mistakes.lua:5): add the two with + first",
        "14: second.hand = \"pull\": needs one of \"none\", \"relaxed\", \"firm\", \"push\", did "
        "you mean "
        "\"push\"?",
    };
    for (int i = 0; i < std::min(found.size(), expected.size()); ++i)
      QCOMPARE(found[i], expected[i]);
    QCOMPARE(found.size(), expected.size());
  }

  void a_check_stops_at_the_first_run() {
    const SessionOptions check{.check_only = true};
    const QByteArray script = two + "trocar.run {}\nerror(\"never reached\")\n";
    const ScriptOutcome outcome = run_script_text(script, {"later=1"}, check);
    QCOMPARE(outcome.findings, QStringList());
    QVERIFY(outcome.session->runs().empty());
    QCOMPARE(run_script_text("trocar.Constant {}\ntrocar.run {}", {}, check).findings.size(), 1);
  }

  void published_rows_come_in_order() {
    const ScriptOutcome outcome = run_script_text(
        "trocar.publish(\"a\", { x = 1, y = \"2 N\" })\n"
        "trocar.publish(\"a\", { 3, true })");
    QCOMPARE(outcome.session->published().size(), std::size_t(2));
    QCOMPARE(outcome.session->published()[0].row.text(), std::string("{x = 1, y = \"2 N\"}"));
    QCOMPARE(outcome.session->published()[1].row.text(), std::string("{3, true}"));
  }

  void random_numbers_follow_the_seed() {
    const auto first = [](std::optional<std::uint64_t> seed) {
      const ScriptOutcome outcome = run_script_text("trocar.publish(\"r\", { math.random() })", {},
                                                    SessionOptions{.seed = seed});
      return outcome.session->published().at(0).row.text();
    };
    QCOMPARE(first({}), first({}));
    QCOMPARE(first(7), first(7));
    QVERIFY(first(7) != first(8));
  }

  void the_operator_ends_the_script_with_its_run() {
    StopFlag stop;
    stop.raise();
    const ScriptOutcome outcome =
        run_script_text("trocar.run { duration = \"1 s\" }\nerror(\"never reached\")", {"later=1"},
                        SessionOptions{.stop = &stop});
    QCOMPARE(outcome.findings, QStringList());
    QCOMPARE(outcome.session->runs().size(), std::size_t(1));
  }
};

QTEST_GUILESS_MAIN(TestScript)
#include "tst_script.moc"
