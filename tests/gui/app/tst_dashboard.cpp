// SPDX-License-Identifier: Apache-2.0
// trocar-dashboard with a runtime of its own, and as people call it.
#include <signal.h>

#include <QImage>
#include <QMessageBox>
#include <QProcess>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "gui/app/dashboard.hpp"
#include "gui/pages/scripts_page.hpp"
#include "gui/plots/time_plot.hpp"
#include "tests/gui/pictures.hpp"

using namespace trocar::gui;

namespace {

const QString wall = TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua";

/// The demo in real time, without leaving files.
struct Demo {
  explicit Demo(const QString& script = wall, const QStringList& options = {}) {
    dashboard.run(script, QStringList{"--clock", "realtime", "--black-box", "off"} + options);
    dashboard.window().show();
  }
  bool wait(const std::function<bool()>& until) { return QTest::qWaitFor(until, 20'000); }
  RunState state() { return dashboard.operators().status().state; }
  /// A machine that is busy with other things may trip it before: it runs then, and is stopped.
  bool is_seen() {
    return wait([&] { return state() == RunState::engaged || state() == RunState::stopped; });
  }
  StopControl& stop() { return dashboard.operators().stop_control(); }
  QString says(const char* name) {
    return dashboard.window().findChild<Readout*>(name)->whole_text();
  }

  Dashboard dashboard;
};

}  // namespace

class TestDashboard : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_starts_connects_and_stops_data() {
    QTest::addColumn<bool>("dialog");
    QTest::newRow("in the window") << false;
    QTest::newRow("with a modal dialog open") << true;
  }
  void it_starts_connects_and_stops() {
    QFETCH(bool, dialog);
    qint64 pid = 0;
    {
      Demo demo;
      pid = demo.dashboard.runtime()->pid();
      QVERIFY(demo.is_seen());
      QVERIFY(demo.wait([&] { return demo.says("mode") == "SIMULATED"; }));
      const int dash =
          trocar::test::longest_dash(demo.dashboard.window(), Theme::light().simulated);
      QVERIFY2(dash > 12 && dash < 40, qPrintable(QString::number(dash)));  // dashed
      QVERIFY(demo.dashboard.operators().status().has_force);
      const auto legend = [&](const char* plot) {
        return demo.dashboard.window().findChild<TimePlot*>(plot)->heading();
      };
      QVERIFY(demo.wait([&] { return legend("force_plot").contains(" N</b>"); }));
      QVERIFY(demo.wait([&] { return legend("tip_plot").contains(" mm</b>"); }));
      QCOMPARE(demo.dashboard.operators().status().force_cap, 20.0);
      QVERIFY(demo.wait([&] { return demo.says("mark").startsWith("01_feel_a_wall.lua "); }));
      QMessageBox box(&demo.dashboard.window());
      box.setModal(true);
      if (dialog) box.show();
      QTest::keyClick(dialog ? static_cast<QWidget*>(&box) : &demo.dashboard.window(), Qt::Key_F12);
      QVERIFY(demo.wait([&] { return demo.stop().state() == StopControl::State::confirmed; }));
      QVERIFY(demo.wait([&] { return demo.state() == RunState::stopped; }));
      QVERIFY(demo.dashboard.runtime()->running());  // a stop ends no run
      qInfo("confirmed after %.0f ms", 1e3 * demo.stop().confirmed_after());
    }
    QVERIFY(kill(static_cast<pid_t>(pid), 0) != 0);  // it ended with the window
  }

  void a_runtime_that_does_not_answer_is_ended() {
    Demo demo;
    QVERIFY(demo.is_seen());
    const auto pid = static_cast<pid_t>(demo.dashboard.runtime()->pid());
    kill(pid, SIGSTOP);
    QTest::keyClick(&demo.dashboard.window(), Qt::Key_F12);
    QVERIFY(demo.wait([&] { return demo.stop().state() == StopControl::State::not_confirmed; }));
    QVERIFY(demo.wait([&] { return !demo.dashboard.runtime()->running(); }));
    QVERIFY(kill(pid, 0) != 0);
    QCOMPARE(demo.stop().text(), std::string("NOT CONFIRMED: use the hardware switch"));
    QVERIFY(demo.wait([&] { return demo.state() == RunState::unknown; }));
    QVERIFY(demo.says("banner").contains("by force"));
  }

  void the_force_axis_shows_the_cap_also_when_it_is_moved() {
    Demo demo;
    QVERIFY(demo.is_seen());
    auto* plot = demo.dashboard.window().findChild<TimePlot*>("force_plot");
    QVERIFY(demo.wait([&] { return plot->value_range().upper >= 20.0; }));
    QVERIFY(plot->value_range().lower <= -20.0);
    ParameterModel& parameters = demo.dashboard.operators().parameters();
    const QString cap = "laparoscope.device.handle_force_cap";
    QVERIFY(demo.wait([&] { return parameters.find(cap) && parameters.may_write(); }));
    QCOMPARE(parameters.ask(*parameters.find(cap), 30.0), QString());
    QVERIFY(demo.wait([&] { return plot->value_range().upper >= 30.0; }));
    QCOMPARE(demo.dashboard.operators().status().force_cap, 30.0);
  }

  void a_runtime_that_ends_by_itself_is_told() {
    Demo demo(wall, {"--for", "1s"});
    QVERIFY(demo.is_seen());
    QVERIFY(demo.wait([&] { return demo.state() == RunState::ended; }));
    QVERIFY(
        demo.wait([&] { return demo.says("banner").startsWith("The run has ended: status "); }));
    QVERIFY(demo.state() == RunState::ended);
  }

  void a_broken_script_is_told() {
    const QTemporaryDir folder;
    QFile file(folder.filePath("broken.lua"));
    QVERIFY(file.open(QFile::WriteOnly));
    file.write("trocar.Wal {}\n");
    file.close();
    Demo demo(file.fileName());
    QVERIFY(demo.wait([&] { return demo.says("banner").contains("status 2"); }));
    QVERIFY2(demo.dashboard.runtime()->said().contains("Wal"),
             qPrintable(demo.dashboard.runtime()->said()));
  }

  void a_law_is_reloaded_from_its_file() {
    Demo demo(TROCAR_SOURCE_DIR "/scripts/tutorial/05_first_fixture.lua");
    QVERIFY(demo.is_seen());
    MainWindow& window = demo.dashboard.window();
    auto* page = window.findChild<ScriptsPage*>();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    QTest::keyClick(&window, Qt::Key_5, Qt::ControlModifier);
    QCOMPARE(window.page(), page);
    const QAbstractItemModel* laws = page->findChild<QTableView*>("script_table")->model();
    QVERIFY(demo.wait([&] { return laws->rowCount() == 1; }));
    QCOMPARE(laws->index(0, ScriptModel::component).data(), QVariant("groove"));
    QCOMPARE(laws->index(0, ScriptModel::file).data(), QVariant("groove.lua"));
    QVERIFY(demo.wait([&] { return laws->index(0, ScriptModel::time).data() != "0.0 µs"; }));
    auto* reload = page->findChild<QPushButton*>("reload");
    QVERIFY(demo.wait([&] { return reload->isEnabled(); }));
    QTest::mouseClick(reload, Qt::LeftButton);
    QVERIFY(demo.wait([&] {
      return laws->index(0, ScriptModel::verdict).data().toString().contains(" at tick ");
    }));
    const QString verdict = laws->index(0, ScriptModel::verdict).data().toString();
    QVERIFY2(verdict.startsWith("took over"), qPrintable(verdict));
    QVERIFY(laws->index(0, ScriptModel::file).data().toString().endsWith("fixtures/groove.lua"));
  }

  void it_is_called_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("says");
    QTest::newRow("help") << QStringList{"--help"} << 0 << "F12 stops the rendering";
    QTest::newRow("version") << QStringList{"--version"} << 0 << "trocar-dashboard ";
    QTest::newRow("no such script") << QStringList{"nothing.lua"} << 2 << "nothing.lua";
    QTest::newRow("no such log") << QStringList{"--open", "nothing.mcap"} << 2 << "nothing.mcap";
    QTest::newRow("no address") << QStringList{"--connect", "http://x"} << 2
                                << "\"http://x\" is no address of a stream";
    QTest::newRow("no theme") << QStringList{"--theme", "pink"} << 2 << "pink";
    QTest::newRow("no size") << QStringList{"--size", "12"} << 2 << "\"12\" is no size";
    QTest::newRow("no page") << QStringList{wall, "--page", "Nothing"} << 2
                             << "there is no page \"Nothing\": there are Operate, ";
    QTest::newRow("pages") << QStringList{"--list-pages"} << 0 << "Operate\nPlots\nParameters\n";
    QTest::newRow("a layout that is none")
        << QStringList{wall, "--layout", wall} << 2 << "01_feel_a_wall.lua: the layout is no JSON";
    QTest::newRow("two subjects") << QStringList{wall, "--connect", "ws://x:1"} << 2 << "excludes";
    QTest::newRow("a log that is none")
        << QStringList{"--open", wall, "--screenshot", "x.png"} << 1 << "trocar-dashboard: ";
    QTest::newRow("a place that cannot be written")
        << QStringList{"--screenshot", "/nowhere/x.png"} << 1 << "/nowhere/x.png cannot be written";
  }
  void it_is_called() {
    QFETCH(QStringList, arguments);
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(beside("trocar-dashboard"), arguments);
    QVERIFY(process.waitForFinished(30'000));
    const QString said = QString::fromUtf8(process.readAll());
    QVERIFY2(process.exitStatus() == QProcess::NormalExit, qPrintable(said));
    QTEST(process.exitCode(), "status");
    QFETCH(QString, says);
    QVERIFY2(said.contains(says), qPrintable(said));
  }

  void without_a_display_it_says_so() {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"})
      environment.remove(name);
    process.setProcessEnvironment(environment);
    process.start(beside("trocar-dashboard"), {wall});
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitCode(), 2);
    QVERIFY(process.readAllStandardError().contains("there is no display"));
  }

  void a_screenshot_needs_no_display_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("scale");
    QTest::newRow("of a run, with options of trocar run")
        << QStringList{wall, "--after", "1.5", "--", "--clock", "realtime", "--black-box", "off"}
        << 1;
    QTest::newRow("of the first start, dark, on a fine screen")
        << QStringList{"--theme", "dark"} << 2;
  }
  void a_screenshot_needs_no_display() {
    QFETCH(QStringList, arguments);
    QFETCH(int, scale);
    const QTemporaryDir folder;
    const QString file = folder.filePath("window.png");
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove("QT_QPA_PLATFORM");
    environment.remove("DISPLAY");
    environment.insert("QT_SCALE_FACTOR", QString::number(scale));
    process.setProcessEnvironment(environment);
    process.start(beside("trocar-dashboard"),
                  QStringList{"--screenshot", file, "--size", "1000x700"} + arguments);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitCode(), 0);
    QCOMPARE(QImage(file).size(), scale * QSize(1000, 700));
  }
};

QTEST_MAIN(TestDashboard)
#include "tst_dashboard.moc"
