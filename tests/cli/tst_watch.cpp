// SPDX-License-Identifier: Apache-2.0
// `trocar run --watch`: a law's file is saved while the graph runs in real time.
#include <QDir>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/trocar_process.hpp"

using namespace trocar::test;

namespace {

QByteArray law(const char* factor, const char* output = "") {
  return QByteArray("return trocar.fixture {\n  outputs = { ") + output +
         " },\n  step = function(p, at, out) out.force:set(0, 0, -" + factor +
         " * at.position.z) end }\n";
}

/// A run of the program, whose law's file is saved again and again.
class Watched {
 public:
  Watched() {
    QVERIFY(QDir::setCurrent(folder_.path()));
    save("script.lua",
         "local laparoscope = trocar.Laparoscope { hand = 'firm' }\n"
         "trocar.LuaFixture { name = 'law', file = 'law.lua', at = laparoscope.tip,\n"
         "                    deadline = '0.8 ms' }\n");
    save("law.lua", law("10"));
    process_.start(TROCAR_BINARY, {"run", "script.lua", "--watch", "--black-box", "off"});
  }
  void save(const char* name, const QByteArray& text) {
    QFile file(name);
    QVERIFY(file.open(QFile::WriteOnly) && file.write(text) == text.size());
  }
  /// Reads until it was said.
  bool says(const QByteArray& wanted) {
    QElapsedTimer timer;
    timer.start();
    while (!said_.contains(wanted) && timer.elapsed() < 60'000 &&
           process_.state() != QProcess::NotRunning) {
      process_.waitForReadyRead(1000);
      said_ += process_.readAllStandardError();
    }
    return said_.contains(wanted);
  }
  QByteArray report() {
    process_.terminate();
    process_.waitForFinished(60'000);
    return process_.readAllStandardOutput();
  }
  const QByteArray& said() const { return said_; }

 private:
  QTemporaryDir folder_;
  QProcess process_;
  QByteArray said_;
};

}  // namespace

class TestWatch : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void what_is_saved_takes_over_and_what_is_wrong_does_not() {
    Watched run;
    QVERIFY2(run.says("law: reloads "), run.said());
    run.save("law.lua", law("11"));
    QVERIFY2(run.says("law: law.lua takes over"), run.said());
    run.save("law.lua", law("12 *"));
    QVERIFY2(run.says("law: refused, the version before goes on: "), run.said());
    run.save("law.lua", law("12", "depth = 'm'"));
    QVERIFY2(run.says("the output \"depth\" is new"), run.said());
    const QByteArray report = run.report();
    QVERIFY2(report.contains("reload: law.lua took over in law at "), report);
    QCOMPARE(report.count("reload: law.lua did not take over in law at "), 2);
  }

  void a_graph_without_laws_is_told_so() {
    const Ran ran = run_trocar({"run", TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua",
                                "--watch", "--for", "0.3s", "--black-box", "off"});
    QVERIFY2(ran.err.contains("--watch: no component's law comes from a file"), ran.err);
  }

  void virtual_time_has_another_way() {
    const Ran ran = run_trocar({"run", TROCAR_SOURCE_DIR "/scripts/tutorial/05_first_fixture.lua",
                                "--watch", "--clock", "simulated"});
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.contains("`reloads` of trocar.run does the same in virtual time"), ran.err);
  }
};

QTEST_GUILESS_MAIN(TestWatch)
#include "tst_watch.moc"
