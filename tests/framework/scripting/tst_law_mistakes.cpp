// SPDX-License-Identifier: Apache-2.0
// What researchers get wrong in a law, and what they are told: file, line and the cure.
#include "tests/support/law_bench.hpp"

using namespace trocar::test;

class TestLawMistakes : public QObject {
  Q_OBJECT

  static void columns() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("said");
  }
  static void row(const char* name, const QByteArray& text, const QString& said) {
    QTest::newRow(name) << text << said;
  }
  static void compare(const LawOutcome& outcome) {
    QFETCH(QString, said);
    QVERIFY2(!outcome.said.isEmpty(), "nothing was said");
    QVERIFY2(outcome.said.front().startsWith(said), qPrintable(outcome.said.join('\n')));
  }

 private Q_SLOTS:
  void in_step_data() {
    columns();  // the body begins at line 5
    row("misspelt parameter", "local f = p.stifness",
        "law.lua:5: p has no \"stifness\", did you mean \"stiffness\"?");
    row("misspelt input", "local z = at.positon.z",
        "law.lua:5: at has no \"positon\", did you mean \"position\"?");
    row("misspelt output", "out.dept = 1",
        "law.lua:5: \"out.dept\" cannot be assigned to, did you mean \"depth\"?");
    row("undeclared output", "out.energy = 1",
        "law.lua:5: \"out.energy\" cannot be assigned to: declare it in outputs");
    row("misspelt state", "\nif state.tron then end",
        "law.lua:6: state has no \"tron\", did you mean \"torn\"?");
    row("undeclared state", "state.count = 1",
        "law.lua:5: \"state.count\" cannot be assigned to: declare it with what it is at first");
    row("misspelt field of a vector", "local v = at.velocity.w",
        "law.lua:5: a vector has no \"w\"");
    row("a field that a vector has not", "out.force.w = 1",
        "law.lua:5: \"a vector.w\" cannot be assigned to: it has x, y and z alone");
    row("assigning a parameter", "p.stiffness = 3",
        "law.lua:5: \"p.stiffness\" cannot be assigned to: a parameter is read");
    row("assigning an input", "at.position = vec(0, 0, 0)",
        "law.lua:5: \"at.position\" cannot be assigned to: an input is read");
    row("changing an input", "at.position:scale(2)",
        "law.lua:5: an input cannot be changed: local q = at.position:copy()");
    row("a global", "torque = 3", "law.lua:5: \"torque\" cannot be assigned to: write local");
    row("an unknown variable", "local depth = 1\nout.depth = deph",
        "law.lua:6: there is no variable \"deph\", did you mean \"depth\"?");
    row("nil arithmetic", "local q\nlocal f = q * 2",
        "law.lua:6: attempt to perform arithmetic on a nil value (local 'q'); give it a value");
    row("a missing return", "local function load(x) local y = 2 * x end\nout.depth = load(1) + 1",
        "law.lua:6: attempt to perform arithmetic on a nil value; give it a value first, and let "
        "every path of a function return one");
    row("a quantity in the loop", "local f = \"3 N\" * at.position.z",
        "law.lua:5: attempt to mul a 'string' with a 'number'; inside the loop numbers are SI");
    row("an output left nil", "out.depth = nil",
        "law.lua:4: out.depth is nil: step has to leave a value there");
    row("an output of the wrong type", "out.depth = \"3 mm\"",
        "law.lua:4: out.depth = \"3 mm\": needs a plain number, in m");
    row("an output that is true", "out.depth = true",
        "law.lua:4: out.depth = true: needs a plain number");
    row("not finite", "out.depth = 1 / 0", "law.lua:4: out.depth = inf is not finite");
    row("a list for a vector", "out.force = { 0, 0, 1 }", "law.lua:4: out.force has no ");
    row("a number for a vector", "out.force = 3", "law.lua:4: out.force = 3: give it a vector");
    row("a dot for a colon", "out.force.set(0, 0, 1)",
        "law.lua:5: a method is called with a colon");
    row("set with too few", "out.force:set(1, 2)", "law.lua:5: set takes three numbers");
    row("vec with too few", "out.force = vec(1, 2)", "law.lua:5: vec takes three numbers");
    row("a vector plus a number", "out.force = at.position + 1",
        "law.lua:5: a vector and a vector are added, not number");
    row("two vectors multiplied", "out.force = at.position * at.velocity",
        "law.lua:5: * of two vectors: a:dot(b) is the number");
    row("vectors compared", "if at.position > 3 then end",
        "law.lua:5: attempt to compare number with table; ");
    row("print", "print(at.position.z)",
        "law.lua:5: print is not there inside the loop: declare an output");
    row("an unknown function of math", "out.depth = math.sinn(1)",
        "law.lua:5: math has no \"sinn\", did you mean \"sin\"?");
    row("a seed of its own", "math.randomseed(1)",
        "law.lua:5: math.randomseed is not there inside the loop: the run");
    row("error of its own", "error(\"too deep\")", "law.lua:5: too deep");
    row("an error deep inside",
        "local function f() error(\"no\") end\nlocal function g() f() end\ng()",
        "law.lua:5: no; called at line 6, line 7");
  }
  void in_step() {
    QFETCH(QByteArray, text);
    compare(run_step(text));
  }

  void in_the_declaration_data() {
    columns();
    const QByteArray step = "step = function() end }";
    row("a wrong unit", "return trocar.fixture {\n outputs = { depth = \"mn\" },\n" + step,
        "law.lua:2: outputs.depth: ");
    row("an unknown type", "return trocar.fixture {\n outputs = { f = \"Vektor3 [N]\" },\n" + step,
        "law.lua:2: outputs.f: there is no type \"Vektor3\", did you mean \"Vector3\"?");
    row("the wrong number of units",
        "return trocar.fixture {\n outputs = { w = \"Wrench [N]\" },\n" + step,
        "law.lua:2: outputs.w: \"Wrench [N]\": a Wrench has 2 units, not 1");
    row("an unknown section", "return trocar.fixture {\n outptus = { depth = \"m\" },\n" + step,
        "law.lua:2: trocar.fixture has no \"outptus\", did you mean \"outputs\"?");
    row("a parameter without braces",
        "return trocar.fixture {\n parameters = {\n k = \"1 N/mm\" },\n" + step,
        "law.lua:3: parameter k = \"1 N/mm\": needs braces, k = { \"1 N/mm\" }");
    row("a range in another unit",
        "return trocar.fixture {\n parameters = {\n k = { \"1 N/mm\", range = { \"0 N\", \"5 N\" } "
        "} "
        "},\n" +
            step,
        "law.lua:3: parameter k: the range of k: ");
    row("a value outside its range",
        "return trocar.fixture {\n parameters = {\n k = { \"9 N\", range = { \"0 N\", \"5 N\" } } "
        "},\n" +
            step,
        "law.lua:3: parameter k: the initial value of k: must be within 0–5 N");
    row("a parameter without a value",
        "return trocar.fixture {\n parameters = { k = {} },\n" + step,
        "law.lua:2: parameter k needs a value at first");
    row("a name that is taken",
        "return trocar.fixture {\n parameters = { strict = { true } },\n" + step,
        "law.lua:2: \"strict\" is a parameter that every law has");
    row("an output that is there",
        "return trocar.fixture {\n outputs = { force = \"N\" },\n" + step,
        "law.lua:2: a fixture has \"force\" already");
    row("no step", "return trocar.fixture {\n outputs = { depth = \"m\" } }",
        "law.lua:1: trocar.fixture needs step = function(p, at, out, state)");
    row("no return", "local law = trocar.fixture { " + step, "law.lua:1: returns nothing: ");
    row("another kind", "return trocar.component { outputs = { d = \"m\" },\n" + step,
        "law.lua:1: returns a trocar.component: use it by trocar.LuaComponent");
    row("a misspelt kind", "return trocar.fixure { " + step,
        "law.lua:1: trocar has no \"fixure\", did you mean \"fixture\"?");
    row("an end too few", "return trocar.fixture {\n step = function() if true then end }",
        "law.lua:2: unexpected symbol near '}'; an end may be missing");
    row("a comma too few", "return trocar.fixture {\n outputs = {}\n step = function() end }",
        "law.lua:3: '}' expected (to close '{' at line 1) near 'step'; a comma or a } is missing");
    row("loops while it loads", "while true do end", "law.lua:1: took more than its 1000000 instr");
  }
  void in_the_declaration() {
    QFETCH(QByteArray, text);
    compare(run_law(text,
                    law_scene + "trocar.LuaFixture { file = \"law.lua\", at = laparoscope.tip }"));
  }

  void in_the_script_data() {
    columns();
    row("no file", "trocar.LuaFixture { at = laparoscope.tip }",
        "script.lua:3: LuaFixture needs its file, e.g. trocar.LuaFixture { file = ");
    row("a file that is not there", "trocar.LuaFixture { file = \"lwa.lua\" }",
        "script.lua:3: file = \"lwa.lua\": there is no file ");
    row("an unknown parameter",
        "trocar.LuaFixture { file = \"law.lua\", at = laparoscope.tip, stifness = \"1 N/mm\" }",
        "script.lua:3: law (a LuaFixture) has no input or parameter \"stifness\", did you mean "
        "\"stiffness\"?");
    row("a parameter in a wrong unit",
        "trocar.LuaFixture { file = \"law.lua\", at = laparoscope.tip, stiffness = \"1 N\" }",
        "script.lua:3: law.stiffness = \"1 N\": needs N/m");
    row("no site", "trocar.LuaFixture { file = \"law.lua\" }",
        "script.lua:3: law.position is not connected");
  }
  void in_the_script() {
    QFETCH(QByteArray, text);
    QFETCH(QString, said);
    const LawOutcome outcome = run_law(
        "return trocar.fixture {\n parameters = { stiffness = { \"1 N/mm\" } },\n"
        " step = function() end }",
        law_scene + text);
    QVERIFY(!outcome.script.findings.isEmpty());
    const QString first = "script.lua:" + outcome.script.findings.front();
    QVERIFY2(first.startsWith(said), qPrintable(first));
  }
};

QTEST_GUILESS_MAIN(TestLawMistakes)
#include "tst_law_mistakes.moc"
