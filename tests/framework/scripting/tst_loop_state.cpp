// SPDX-License-Identifier: Apache-2.0
// The world of a script in the loop, alone: what it can see, and how it ends when it goes too far.
#include "framework/scripting/loop_state.hpp"

#include <QTest>

using namespace trocar::lua;

namespace {

/// What the text returns, as a text; or the error.
QString run(const QByteArray& text, const LoopLimits& limits = {}) {
  LoopState state(limits, "law.lua", 1);
  if (!state.run_file(text.toStdString(), 1)) return state.error();
  const QString result = luaL_tolstring(state.lua(), -1, nullptr);
  return result;
}

/// What comes of a function that the text returns, called as a step.
QString step(const QByteArray& body, const LoopLimits& limits = {}) {
  LoopState state(limits, "law.lua", 1);
  if (!state.run_file("return function() " + body.toStdString() + "\nend", 1))
    return QString("does not load: ") + state.error();
  return state.call(0, 0) ? "fine" : QString(state.error());
}

}  // namespace

class TestLoopState : public QObject {
  Q_OBJECT

  static void columns() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("result");
  }
  static void row(const char* name, const QByteArray& text, const QString& result) {
    QTest::newRow(name) << text << result;
  }

 private Q_SLOTS:
  void vectors_data() {
    columns();
    row("a sum", "return tostring(vec(1, 2, 3) + vec(1, 1, 1))", "(2, 3, 4)");
    row("a difference", "return tostring(vec(1, 2, 3) - vec(1, 1, 1))", "(0, 1, 2)");
    row("times a number", "return tostring(2 * vec(1, 2, 3) * 2)", "(4, 8, 12)");
    row("by a number", "return tostring(-vec(2, 4, 6) / 2)", "(-1, -2, -3)");
    row("dot", "return tostring(vec(1, 2, 3):dot(vec(1, 1, 1)))", "6");
    row("cross", "return tostring(vec(1, 0, 0):cross(vec(0, 1, 0)))", "(0, 0, 1)");
    row("norm", "return tostring(vec(2, 3, 6):norm())", "7.0");
    row("in place",
        "return tostring(vec(0, 0, 0):set(1, 2, 3):add(vec(1, 1, 1)):scale(2):sub(vec(1, 0, 0))"
        ":add_scaled(vec(1, 1, 1), 10))",
        "(13, 16, 18)");
    row("a cross product in place",
        "return tostring(vec(0, 0, 0):set_cross(vec(1, 0, 0), vec(0, 1, 0)))", "(0, 0, 1)");
    row("a copy is another", "local a = vec(1, 2, 3)\nlocal b = a:copy()\nb.x = 9\nreturn a.x",
        "1");
  }
  void vectors() {
    QFETCH(QByteArray, text);
    QFETCH(QString, result);
    QCOMPARE(run(text), result);
  }

  void its_library_data() {
    columns();
    row("sort", "local t = {3, 1, 2, 5, 4}\ntable.sort(t)\nreturn table.concat(t, ' ')",
        "1 2 3 4 5");
    row("sort backwards",
        "local t = {3, 1, 2}\ntable.sort(t, function(a, b) return a > b end)\n"
        "return table.concat(t, ' ')",
        "3 2 1");
    row("insert and remove",
        "local t = {1, 2}\ntable.insert(t, 3)\ntable.insert(t, 1, 0)\ntable.remove(t)\n"
        "table.remove(t, 1)\nreturn table.concat(t, ' ')",
        "1 2");
    row("unpack", "return select('#', table.unpack({1, 2, 3}))", "3");
    row("pairs in order",
        "local s = ''\nfor k, v in pairs { z = 1, a = 2, 7, 8, m = 3 } do s = s .. k .. v end\n"
        "return s",
        "1728a2m3z1");
    row("format", "return string.format('%5.2f|%d%%', 1.5, 3)", " 1.50|3%");
    row("rep", "return ('ab'):rep(3, '-')", "ab-ab-ab");
    row("no addresses", "return tostring({}) .. tostring(type)", "tablefunction");
    row("pcall", "local ok, why = pcall(error, 'no', 0)\nreturn tostring(ok) .. why", "falseno");
  }
  void its_library() {
    QFETCH(QByteArray, text);
    QFETCH(QString, result);
    QCOMPARE(run(text), result);
  }

  void what_is_not_there_is_refused_with_a_cure_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"io",           "os",           "package",    "require",
                             "dofile",       "loadfile",     "load",       "debug",
                             "print",        "xpcall",       "coroutine",  "collectgarbage",
                             "setmetatable", "getmetatable", "rawset",     "rawget",
                             "next",         "_G",           "utf8",       "string.gsub",
                             "string.find",  "string.dump",  "table.move", "math.randomseed"})
      QTest::newRow(name) << name;
  }
  void what_is_not_there_is_refused_with_a_cure() {
    QFETCH(QString, name);
    const QString error = step(("local x = " + name + "\n").toUtf8());
    QVERIFY2(error.startsWith("law.lua:1: " + name + " is not there inside the loop: "),
             qPrintable(error));
  }

  void limits_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("part");
    const auto row = [](const char* name, const QByteArray& text, const QString& part) {
      QTest::newRow(name) << text << part;
    };
    row("instructions", "while true do end", "law.lua:1: took more than its 10000 instructions");
    row("pcall does not help", "while true do pcall(function() while true do end end) end",
        "law.lua:1: took more than its 10000 instructions");
    row("memory", "local t = {}\nfor i = 1, 1e9 do t = { t } end",
        "law.lua:2: took more than its 10000 instructions");
    row("a huge table", "local t = {}\nfor i = 1, 9000 do t[i] = i\nend",
        "law.lua:2: needs a table");
    row("a long text", "local s = 'x'\nwhile true do s = s .. s end",
        "law.lua:2: makes a text of more than 1024 bytes");
    row("deep recursion", "local function f() return 1 + f() end\nf()",
        "needs a table, or a stack");
    row("format", "for i = 1, 60 do string.format('%.99f', 1e308) end",
        "took more than its 10000 instructions");
    row("its place and who called",
        "local function deep() local x = nil + 1 end\nlocal function mid() deep() end\nmid()",
        "law.lua:1: attempt to perform arithmetic on a nil value; give it a value first, and let "
        "every path of a function return one; called at line 2, line 3");
  }
  void limits() {
    QFETCH(QByteArray, text);
    QFETCH(QString, part);
    const QString error = step(text);
    QVERIFY2(error.contains(part), qPrintable(error));
  }

  void memory_has_a_cap() {
    const LoopLimits wide{.instructions = 1'000'000};
    const QString error = step("local t = {}\nwhile true do t = { t } end", wide);
    QVERIFY2(error.startsWith("law.lua:2: holds more than its 512 KiB"), qPrintable(error));
  }

  void strict_mode_refuses_to_allocate() {
    const LoopLimits strict{.strict = true};
    QCOMPARE(step("local a = 1 + 2", strict), "fine");
    const QString error = step("local a = 1\nlocal b = {}\nlocal c = 2", strict);
    QVERIFY2(error.startsWith("law.lua:2: allocates") || error.startsWith("law.lua:3: allocates"),
             qPrintable(error));
  }

  void a_script_that_allocates_lives_on_by_the_collector() {
    LoopState state({}, "law.lua", 1);
    QVERIFY(state.run_file("return function() local t = vec(1, 2, 3) + vec(4, 5, 6) end", 1));
    state.settle();
    std::size_t most = 0;
    for (int tick = 0; tick < 20'000; ++tick) {
      lua_pushvalue(state.lua(), -1);
      QVERIFY2(state.call(0, 0), state.error());
      QVERIFY(state.guard().allocations() >= 6);  // and Lua's own after a cycle
      state.collect();
      most = std::max(most, state.guard().memory());
    }
    QVERIFY2(most < 256 * 1024, qPrintable(QString::number(most)));
  }

  void too_little_memory_is_refused() {
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, LoopState({.memory = 8 * 1024}, "law.lua", 1));
  }
};

QTEST_APPLESS_MAIN(TestLoopState)
#include "tst_loop_state.moc"
