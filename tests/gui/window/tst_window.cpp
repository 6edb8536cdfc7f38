// SPDX-License-Identifier: Apache-2.0
// The window with a run behind it, over real sockets: the ten rules of the operator's first screen.
#include <QAbstractButton>
#include <QAbstractItemModelTester>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QShortcut>
#include <QSignalSpy>
#include <QTabBar>

#include "gui/app/dashboard.hpp"
#include "gui/app/replay.hpp"
#include "gui/pages/force_meter.hpp"
#include "gui/pages/start_page.hpp"
#include "gui/plots/time_plot.hpp"
#include "tests/gui/pictures.hpp"
#include "tests/support/script_bench.hpp"
#include "tests/support/size_limit.hpp"
#include "tests/support/slow_link.hpp"
#include "tests/support/stream_rig.hpp"

using namespace trocar;
using namespace trocar::gui;
using trocar::test::StreamRig;

namespace {

/// A dashboard that looks at a run of the rig.
struct Looking {
  explicit Looking(const StreamRig& rig, const QString& query = {})
      : Looking(QUrl(rig.url(query))) {}
  explicit Looking(const QUrl& url) {
    dashboard.attach(url);
    dashboard.window().show();
  }
  bool wait(const std::function<bool()>& until) { return QTest::qWaitFor(until, 10'000); }
  bool is_engaged() {
    return wait([&] { return dashboard.operators().status().state == RunState::engaged; });
  }
  Readout& readout(const char* name) { return *dashboard.window().findChild<Readout*>(name); }
  QString says(const char* name) { return readout(name).whole_text(); }
  StopControl& stop() { return dashboard.operators().stop_control(); }
  ParameterModel& parameters() { return dashboard.operators().parameters(); }
  const ParameterView& gain() {
    return parameters().parameters()[static_cast<std::size_t>(*parameters().find("meter.gain"))];
  }
  bool knows_gain() {
    return wait([&] { return parameters().find("meter.gain") && parameters().may_write(); });
  }

  Dashboard dashboard;
};

bool is_interactive(const QWidget& widget) {
  return qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
         qobject_cast<const QAbstractSlider*>(&widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
         qobject_cast<const QComboBox*>(&widget) != nullptr ||
         qobject_cast<const QLineEdit*>(&widget) != nullptr ||
         qobject_cast<const QTabBar*>(&widget) != nullptr ||
         qobject_cast<const QAbstractItemView*>(&widget) != nullptr;
}

/// What Qt makes within other widgets: their own name and key are the others'.
bool is_part(const QWidget& widget) {
  return widget.objectName().startsWith("qt_") || widget.inherits("QComboBoxListView") ||
         widget.inherits("QHeaderView") || widget.inherits("QScrollBar") ||
         widget.inherits("QTableCornerButton") ||
         qobject_cast<const QAbstractSpinBox*>(widget.parentWidget()) != nullptr ||
         qobject_cast<const QTabBar*>(widget.parentWidget()) != nullptr ||
         qobject_cast<const QLineEdit*>(widget.parentWidget()) != nullptr;
}

}  // namespace

class TestWindow : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // --- rule 1 ---
  void f12_stops_from_everywhere_data() {
    QTest::addColumn<QString>("from");
    for (const char* from :
         {"the window", "a line that is typed in", "a modal dialog", "the button", "another page"})
      QTest::newRow(from) << QString(from);
  }
  void f12_stops_from_everywhere() {
    QFETCH(QString, from);
    StreamRig rig;
    rig.run();
    Looking looking(rig, "?token=wrong");  // to stop needs no right
    QVERIFY(looking.is_engaged());
    MainWindow& window = looking.dashboard.window();
    QVERIFY(!looking.parameters().may_write());
    QWidget* focus = &window;
    QMessageBox box(&window);
    if (from == "a line that is typed in") {
      window.show_page(3);
      focus = window.findChild<QLineEdit*>("annotation");
    }
    if (from == "another page") window.show_page(1);
    if (from == "a modal dialog") {
      box.open();
      focus = &box;
    }
    if (from == "the button")
      QTest::mouseClick(&window.state_strip().stop_button(), Qt::LeftButton);
    else
      QTest::keyClick(focus, Qt::Key_F12);
    QVERIFY(looking.stop().state() == StopControl::State::stopping);
    QVERIFY(looking.wait([&] { return looking.stop().state() == StopControl::State::confirmed; }));
    const QString said = window.state_strip().stop_button().text();
    QVERIFY2(said.contains("STOPPED, confirmed after "), qPrintable(said));
    QVERIFY(said.contains("software stop"));
    QVERIFY(looking.wait([&] { return looking.says("state") == "■ STOPPED"; }));
    QVERIFY(looking.says("fault").contains("operator stop"));
  }

  void f12_stops_over_a_slow_link_data() {
    QTest::addColumn<int>("delay_ms");  // each way
    QTest::addColumn<bool>("in_time");
    QTest::newRow("20 ms") << 20 << true;
    QTest::newRow("300 ms") << 300 << false;
  }
  void f12_stops_over_a_slow_link() {
    QFETCH(int, delay_ms);
    QFETCH(bool, in_time);
    StreamRig rig;
    rig.run();
    const trocar::test::SlowLink slow(static_cast<quint16>(QUrl(rig.url()).port()), delay_ms);
    QUrl url(rig.url());
    url.setPort(slow.port());
    Looking looking(url);
    QVERIFY(looking.is_engaged());
    QSignalSpy late(&looking.stop(), &StopControl::not_confirmed);
    QTest::keyClick(&looking.dashboard.window(), Qt::Key_F12);
    QVERIFY(looking.wait([&] { return looking.stop().state() == StopControl::State::confirmed; }));
    QVERIFY(looking.stop().confirmed_after() >= 2e-3 * delay_ms);
    // What comes too late is told as such, and what came after all too.
    QCOMPARE(late.isEmpty(), in_time);
    QVERIFY(looking.wait([&] { return looking.says("state") == "■ STOPPED"; }));
  }

  void f12_stops_while_a_log_loads() {
    const QTemporaryDir folder;
    const std::string log = folder.filePath("long.mcap").toStdString();
    QCOMPARE(trocar::test::run_script_file(TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua",
                                           {}, {.duration = 20.0, .record = log})
                 .findings,
             QStringList());
    StreamRig rig;
    rig.run();
    Looking looking(rig);
    QVERIFY(looking.is_engaged());
    Replay replay(log);
    replay.window().show();
    QCOMPARE(replay.feed().state(), LogFeed::State::loading);
    QTest::keyClick(&replay.window(), Qt::Key_F12);  // wherever the focus is
    QVERIFY(looking.stop().state() == StopControl::State::stopping);
    QVERIFY(looking.wait([&] { return looking.stop().state() == StopControl::State::confirmed; }));
    QVERIFY(looking.wait([&] { return replay.feed().state() == LogFeed::State::loaded; }));
  }

  void the_stop_never_moves_and_is_never_disabled() {
    StreamRig rig;
    rig.run();
    Looking looking(rig);
    MainWindow& window = looking.dashboard.window();
    QPushButton& stop = window.state_strip().stop_button();
    QVERIFY(looking.is_engaged());
    const QRect place(stop.mapTo(&window, QPoint()), stop.size());
    const auto stays = [&] {
      window.refresh();
      QCoreApplication::processEvents();
      return stop.isEnabled() && stop.isVisible() &&
             QRect(stop.mapTo(&window, QPoint()), stop.size()) == place;
    };
    for (int page = 0; page < static_cast<int>(window.pages().size()); ++page) {
      window.show_page(page);
      QVERIFY(stays());
    }
    window.state_strip().set_notice(QString(500, 'x'));
    window.state_strip().say(QString(500, 'y'));
    QVERIFY(stays());
    window.set_theme(Theme::dark_one());
    QVERIFY(stays());
    looking.stop().stop();
    QVERIFY(stays());
    QVERIFY(looking.wait([&] { return looking.stop().state() == StopControl::State::confirmed; }));
    QVERIFY(stays());
    QCOMPARE(stop.focusPolicy(), Qt::NoFocus);
    QVERIFY(stop.accessibleName().startsWith("Software stop"));
  }

  // --- rule 2 ---
  void the_state_follows_the_rows_and_not_the_button() {
    StreamRig rig;
    Looking looking(rig);
    rig.begin();
    QVERIFY(looking.wait([&] { return looking.dashboard.data().track("main") != nullptr; }));
    const auto feed = [&](std::int64_t tick, std::int64_t flags) {
      std::vector<std::byte> row = rig.row(tick);
      const RowHeader header{.tick = tick, .time = tick * 1'000'000, .flags = flags};
      std::memcpy(row.data(), &header, sizeof header);
      rig.service.rows().row(0, row);
    };
    std::int64_t tick = 0;
    // Rows from before it listens are not for it.
    QVERIFY(looking.wait([&] {
      feed(tick++, 2);
      return looking.dashboard.operators().status().state == RunState::engaged;
    }));
    QTest::keyClick(&looking.dashboard.window(), Qt::Key_F12);
    // It is fed by hand, and nobody takes requests: it renders on, and that is what is said.
    for (int i = 0; i < 10; ++i) feed(tick++, 2);
    QVERIFY(
        looking.wait([&] { return looking.stop().state() == StopControl::State::not_confirmed; }));
    QVERIFY(looking.wait([&] {
      return looking.dashboard.window().state_strip().stop_button().text().contains(
          "NOT CONFIRMED:\nuse the hardware switch");
    }));
    QVERIFY(looking.wait([&] {
      feed(tick++, 2);
      return looking.dashboard.operators().status().state == RunState::engaged;
    }));
    looking.dashboard.window().refresh();
    QCOMPARE(looking.says("state"), QString("▲ ENGAGED"));
    QCOMPARE(looking.stop().state(), StopControl::State::not_confirmed);
    rig.end();
  }

  // --- rule 3 ---
  void a_lost_link_is_unknown_and_reconnecting_engages_nothing() {
    auto rig = std::make_unique<StreamRig>();
    const std::string address = "127.0.0.1:" + std::to_string(QUrl(rig->url()).port());
    rig->run();
    Looking looking(*rig);
    QVERIFY(looking.is_engaged());
    QVERIFY(looking.dashboard.window().findChild<StaleVeil*>()->isHidden());
    rig.reset();
    QVERIFY(looking.wait([&] { return looking.says("state").contains("UNKNOWN"); }));
    QCOMPARE(looking.says("state"), QString("? UNKNOWN: the device may still be engaged"));
    QVERIFY(looking.dashboard.window().findChild<StaleVeil*>()->isVisible());
    QVERIFY(!looking.dashboard.window().state_strip().engage_button().isEnabled());
    rig = std::make_unique<StreamRig>(ServiceType::Settings{{"address", address}});
    QVERIFY(looking.wait([&] {
      return looking.says("link").startsWith("link ") && looking.says("link").endsWith("ms");
    }));
    QVERIFY(!looking.says("state").contains("ENGAGED"));
  }

  void a_loop_that_is_silent_is_unknown_too() {
    StreamRig rig;
    Looking looking(rig);
    rig.begin();
    QVERIFY(looking.wait([&] { return looking.dashboard.data().track("main") != nullptr; }));
    std::int64_t tick = 0;
    QVERIFY(looking.wait([&] {
      rig.feed(tick, tick + 1);
      ++tick;
      return !looking.dashboard.data().track("main")->empty();
    }));
    QVERIFY(looking.wait([&] {
      return looking.says("state") == "? UNKNOWN: no rows: the device may still be engaged";
    }));
    rig.feed(tick, tick + 10);
    QVERIFY(looking.wait([&] { return !looking.says("state").contains("UNKNOWN"); }));
    rig.end();
    QVERIFY(looking.wait([&] { return looking.says("state") == "○ RUN ENDED"; }));
  }

  // --- rule 4 ---
  void alarms_latch_until_the_device_acknowledges() {
    StreamRig rig;
    rig.run();
    Looking looking(rig);
    QVERIFY(looking.is_engaged());
    MainWindow& window = looking.dashboard.window();
    QCOMPARE(looking.says("fault"), QString("no fault"));
    QVERIFY(!window.state_strip().acknowledge_button().isEnabled());
    QTest::keyClick(&window, Qt::Key_F12);
    QVERIFY(looking.wait([&] { return looking.says("fault").contains("arm: operator stop"); }));
    QVERIFY(looking.wait([&] { return window.state_strip().acknowledge_button().isEnabled(); }));
    QTest::qWait(150);  // the device is to be sound for 0.1 s
    QTest::keyClick(&window, Qt::Key_K, Qt::ControlModifier);
    QVERIFY(looking.wait([&] { return looking.says("fault") == "no fault"; }));
    QVERIFY(looking.wait([&] { return looking.says("state") == "● HOLDING"; }));
  }

  // --- rule 5 ---
  void freeze_stops_the_picture_only() {
    StreamRig rig;
    rig.run();
    Looking looking(rig);
    QVERIFY(looking.is_engaged());
    MainWindow& window = looking.dashboard.window();
    auto* plot = window.findChild<TimePlot*>("force_plot");
    QTest::keyClick(&window, Qt::Key_F8);
    QVERIFY(plot->frozen());
    const std::int64_t tick = looking.dashboard.operators().status().tick;
    QVERIFY(looking.wait([&] { return looking.dashboard.operators().status().tick > tick + 100; }));
    window.refresh();
    QVERIFY2(looking.says("frozen").startsWith("FROZEN, behind 0."),
             qPrintable(looking.says("frozen")));
    QVERIFY(looking.says("frozen").endsWith("the recording goes on"));
    QTest::keyClick(&window, Qt::Key_F8);
    QVERIFY(!plot->frozen());
    for (const auto& key : window.keys())
      QVERIFY(!key.second.contains("pause", Qt::CaseInsensitive));
  }

  // --- rule 6 ---
  void a_recording_that_fails_is_told_within_a_second() {
    const QTemporaryDir folder;
    const QString before = QDir::currentPath();
    QDir::setCurrent(folder.path());
    StreamRig rig;
    rig.run();
    Looking looking(rig);
    QVERIFY(looking.is_engaged());
    QVERIFY(looking.knows_gain());
    QCOMPARE(looking.says("recording"), QString("not recording"));
    QTest::keyClick(&looking.dashboard.window(), Qt::Key_R, Qt::ControlModifier);
    QVERIFY(looking.wait([&] { return looking.says("recording").startsWith("REC 00:0"); }));
    QVERIFY(looking.says("recording").endsWith("lost 0"));
    QVERIFY(looking.wait([&] { return looking.says("mark").contains("trial recording_1.mcap"); }));
    {
      // No file may grow any more.
      const trocar::test::SizeLimit full(4096);
      QVERIFY(
          looking.wait([&] { return looking.says("banner").startsWith("RECORDING FAILED: "); }));
    }
    QVERIFY2(looking.says("banner").contains(
                 "rows lost, and recording_1.mcap is INCOMPLETE; forces go on"),
             qPrintable(looking.says("banner")));
    QVERIFY(looking.readout("banner").isVisible());
    QVERIFY(looking.wait([&] { return looking.dashboard.operators().recording().lost() > 100; }));
    QVERIFY(
        looking.wait([&] { return looking.says("mark").endsWith("recording_1.mcap INCOMPLETE"); }));
    const std::int64_t tick = looking.dashboard.operators().status().tick;
    QVERIFY(looking.wait([&] { return looking.dashboard.operators().status().tick > tick + 50; }));
    QDir::setCurrent(before);
  }

  void a_log_of_the_run_itself_that_fails_is_told_too() {
    const QTemporaryDir folder;
    const QString before = QDir::currentPath();
    QDir::setCurrent(folder.path());
    StreamRig rig;
    rig.record("trial.mcap");
    Looking looking(rig);
    QVERIFY(looking.is_engaged());
    QVERIFY(looking.wait([&] { return looking.says("recording").startsWith("REC 00:0"); }));
    QVERIFY(looking.wait([&] { return looking.says("mark").endsWith("trial trial.mcap"); }));
    {
      const trocar::test::SizeLimit full(4096);
      QVERIFY(
          looking.wait([&] { return looking.says("banner").startsWith("RECORDING FAILED: "); }));
    }
    QVERIFY2(looking.says("banner").contains("rows lost, and trial.mcap is INCOMPLETE; forces"),
             qPrintable(looking.says("banner")));
    QVERIFY(looking.wait([&] { return looking.dashboard.operators().recording().lost() > 100; }));
    QVERIFY(looking.says("mark").endsWith("trial.mcap INCOMPLETE"));
    QCOMPARE(looking.dashboard.operators().status().state, RunState::engaged);
    QDir::setCurrent(before);
  }

  // --- rules 7 and 8 ---
  void numbers_have_units_and_stale_ones_are_grey_not_zero() {
    RunStatus status;
    status.rate = 1000.0;
    status.has_force = true;
    status.force = 6.4;
    status.force_cap = 20.0;
    status.state = RunState::engaged;
    const auto picture = [&](RunState state) {
      status.state = state;
      ForceMeter meter;
      meter.resize(260, 120);
      meter.show_status(status, Theme::light());
      if (!meter.accessibleDescription().startsWith("6.4 N of 20 N")) return QImage();
      return meter.grab().toImage();
    };
    const QImage fresh = picture(RunState::engaged), stale = picture(RunState::unknown);
    QVERIFY(!fresh.isNull() && !stale.isNull());
    QVERIFY(fresh != stale);
    for (int x = 0; x < stale.width(); ++x)  // no blue bar in it any more
      QVERIFY(stale.pixelColor(x, 68) != Theme::light().accent);
    QVERIFY(fresh.pixelColor(20, 68) == Theme::light().accent);
    status.has_force = false;
    QVERIFY(picture(RunState::engaged).isNull());
  }

  void every_number_of_a_run_has_a_unit_or_is_a_count() {
    StreamRig rig;
    rig.run();
    Looking looking(rig);
    QVERIFY(looking.is_engaged());
    QVERIFY(looking.wait([&] { return looking.says("loop").contains(" Hz"); }));
    static const QRegularExpression number("(\\S+) (-?[0-9.]+)(?: (\\S+)|$)");
    const QStringList units = {"Hz", "µs", "ms", "s", "%", "N", "mm"}, counts = {"missed", "tick"};
    for (const char* name : {"loop", "link", "mark"}) {
      if (looking.says(name).startsWith("a log")) continue;
      for (auto found = number.globalMatch(looking.says(name)); found.hasNext();) {
        const QRegularExpressionMatch one = found.next();
        QVERIFY2(units.contains(one.captured(3)) || counts.contains(one.captured(1)),
                 qPrintable(looking.says(name)));
      }
    }
  }

  void a_stale_number_is_grey_and_stays() {
    auto rig = std::make_unique<StreamRig>();
    rig->run();
    Looking looking(*rig);
    QVERIFY(looking.is_engaged());
    QVERIFY(looking.wait([&] { return looking.says("loop").startsWith("LOOP 1000 Hz"); }));
    const auto is_grey = [&] {
      return looking.readout("loop").styleSheet().contains(Theme::light().muted.name());
    };
    QVERIFY(!is_grey());
    rig.reset();
    QVERIFY(looking.wait([&] { return looking.says("state").contains("UNKNOWN"); }));
    looking.dashboard.window().refresh();
    QVERIFY(is_grey());
    QVERIFY2(looking.says("loop").startsWith("LOOP 1000 Hz"), qPrintable(looking.says("loop")));
    QVERIFY(looking.says("loop").endsWith("OLD"));
  }

  // --- rule 9 ---
  void an_edit_goes_from_asked_to_ramped_and_back() {
    StreamRig rig;
    rig.run();
    Looking looking(rig);
    QVERIFY(looking.knows_gain());
    ParameterModel& model = looking.parameters();
    const QAbstractItemModelTester tester(&model);
    const int row = *model.find("meter.gain");
    QCOMPARE(looking.gain().value, 2.0);
    QCOMPARE(model.ask(row, 5.0), QString());
    QCOMPARE(looking.gain().edit, ParameterView::Edit::asked);
    QCOMPARE(looking.gain().edit_text(), QString("asked: 5 N"));
    QVERIFY(looking.wait([&] { return looking.gain().edit == ParameterView::Edit::ramped; }));
    QVERIFY(looking.gain().tick >= 0);
    QVERIFY(looking.wait([&] { return looking.gain().value == 5.0; }));
    QVERIFY(looking.gain().changed());
    model.history().undo();
    QVERIFY(looking.wait([&] { return looking.gain().value == 2.0; }));
    model.history().redo();
    QVERIFY(looking.wait([&] { return looking.gain().value == 5.0; }));
    QVERIFY(model.ask(row, 9.5).contains("9.5 N is outside of ≤ 9 N"));
    QVERIFY(!model.ask(*model.find("meter.fixed"), 1.0).isEmpty());
    // What the runtime itself refuses goes back.
    looking.dashboard.operators().sources().link->set_parameter("meter.gain", 12.0);
    QSignalSpy remarks(&looking.dashboard.operators(), &Operator::remark);
    QVERIFY(looking.wait([&] { return !remarks.empty(); }));
    QCOMPARE(looking.gain().value, 5.0);
  }

  void edits_of_one_gesture_are_undone_together() {
    StreamRig rig;
    rig.run();
    Looking looking(rig);
    QVERIFY(looking.knows_gain());
    ParameterModel& model = looking.parameters();
    const int row = *model.find("meter.gain");
    const int gesture = model.begin_gesture();
    for (const double value : {3.0, 4.0, 5.0}) model.ask(row, value, gesture);
    QCOMPARE(model.history().count(), 1);
    model.ask(row, 6.0, model.begin_gesture());
    QCOMPARE(model.history().count(), 2);
    QVERIFY(looking.wait([&] { return looking.gain().value == 6.0; }));
    model.history().undo();
    QVERIFY(looking.wait([&] { return looking.gain().value == 5.0; }));
    model.history().undo();
    QVERIFY(looking.wait([&] { return looking.gain().value == 2.0; }));
  }

  void a_second_client_only_reads_and_sees_the_edits_of_the_first() {
    StreamRig rig;
    rig.run();
    Looking first(rig), second(rig, "?token=wrong");
    QVERIFY(first.knows_gain());
    QVERIFY(second.wait([&] { return second.parameters().find("meter.gain").has_value(); }));
    const int row = *second.parameters().find("meter.gain");
    QVERIFY(second.parameters().ask(row, 4.0).contains("only looks"));
    const QModelIndex cell = second.parameters().index(row, ParameterModel::value);
    QVERIFY(!second.parameters().flags(cell).testFlag(Qt::ItemIsEditable));
    QVERIFY(first.parameters().flags(cell.siblingAtRow(row)).testFlag(Qt::ItemIsEditable) ||
            first.parameters().setData(first.parameters().index(row, ParameterModel::value), 4.0));
    first.parameters().ask(row, 4.0);
    QVERIFY(second.wait([&] { return second.gain().value == 4.0; }));
  }

  // --- rule 10 ---
  void mode_and_marks_stand_in_every_picture() {
    StreamRig rig;
    rig.service.add_script("push.lua", "return 1");
    rig.run();
    Looking looking(rig);
    QVERIFY(looking.is_engaged());
    MainWindow& window = looking.dashboard.window();
    const QString mark = "push.lua 6c3f3a6f";
    QVERIFY(looking.wait([&] { return looking.says("mark").startsWith("push.lua "); }));
    QCOMPARE(looking.says("mark").size(), mark.size());
    QVERIFY(looking.wait([&] { return window.windowTitle().contains(looking.says("mark")); }));
    QVERIFY(window.windowTitle().startsWith("LIVE – "));
    QVERIFY(looking.says("mode") == "LIVE");
    for (const Theme& theme : {Theme::light(), Theme::dark_one()}) {
      window.set_theme(theme);
      QVERIFY(trocar::test::longest_dash(window, theme.live) > 1000);  // whole
    }
    for (std::size_t page = 0; page < window.pages().size(); ++page) {
      window.show_page(static_cast<int>(page));
      window.refresh();
      for (const char* name : {"mode", "mark"}) {
        QVERIFY(looking.readout(name).isVisible());
        QVERIFY2(looking.wait([&] { return looking.readout(name).text() == looking.says(name); }),
                 qPrintable(QString("%1 has %2").arg(name).arg(looking.readout(name).width())));
      }
    }
  }

  // --- the whole ---
  void everything_can_be_named_and_reached() {
    StreamRig rig;
    rig.run();
    Looking looking(rig);
    QVERIFY(looking.knows_gain());
    MainWindow& window = looking.dashboard.window();
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
      if (!is_interactive(*widget) || is_part(*widget)) continue;
      const QString who = QString("%1 \"%2\" in %3")
                              .arg(widget->metaObject()->className(), widget->objectName(),
                                   widget->parentWidget()->metaObject()->className());
      QVERIFY2(!widget->objectName().isEmpty(), qPrintable(who));
      QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(who));
      QVERIFY2(widget->objectName() == "stop" || (widget->focusPolicy() & Qt::TabFocus) != 0,
               qPrintable(who));
    }
  }

  void no_two_shortcuts_clash_and_all_are_on_the_sheet() {
    StreamRig rig;
    Looking looking(rig);
    MainWindow& window = looking.dashboard.window();
    std::map<QString, int> keys;
    for (const QShortcut* shortcut : window.findChildren<QShortcut*>())
      ++keys[shortcut->key().toString()];
    for (const auto& key : keys) QVERIFY2(key.second == 1, qPrintable(key.first));
    QVERIFY(keys.count("F12") == 0);  // is taken before all others
    QVERIFY(QTest::qWaitForWindowActive(&window));
    QTest::keyClick(&window, Qt::Key_F1);
    auto* sheet = window.findChild<QMessageBox*>("shortcut_sheet");
    QVERIFY(sheet != nullptr);
    for (const Page* page : window.pages()) {
      QVERIFY(!page->shortcut().isEmpty());
      QVERIFY2(sheet->text().contains(page->title()), qPrintable(page->title()));
    }
    QVERIFY(sheet->text().contains("F12"));
    sheet->close();
  }

  void each_page_comes_with_its_key_in_both_themes() {
    StreamRig rig;
    rig.run();
    Looking looking(rig);
    QVERIFY(looking.is_engaged());
    MainWindow& window = looking.dashboard.window();
    for (const Theme& theme : {Theme::light(), Theme::dark_one()}) {
      window.set_theme(theme);
      for (Page* page : window.pages()) {
        const QKeyCombination key = page->shortcut()[0];
        QTest::keyClick(&window, key.key(), key.keyboardModifiers());
        QCOMPARE(window.page(), page);
        window.refresh();
        QVERIFY(window.grab().size() == QSize(1280, 720));
      }
    }
    QVERIFY(window.minimumSizeHint().width() <= 1280);
    QVERIFY(window.minimumSizeHint().height() <= 720);
  }

  void a_remark_goes_into_the_log() {
    StreamRig rig;
    rig.run();
    Looking looking(rig);
    QVERIFY(looking.knows_gain());
    MainWindow& window = looking.dashboard.window();
    QTest::keyClick(&window, Qt::Key_M, Qt::ControlModifier);
    auto* line = window.findChild<QLineEdit*>("annotation");
    QTest::keyClicks(line, "needle touched");
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY(looking.wait([&] {
      const auto& events = looking.dashboard.data().events();
      return !events.empty() && events.back().detail == "needle touched";
    }));
    QVERIFY(line->text().isEmpty());
  }

  void nobody_there_is_said() {
    Dashboard dashboard;
    dashboard.attach(QUrl("ws://127.0.0.1:1"));
    auto* banner = dashboard.window().findChild<Readout*>("banner");
    QVERIFY(QTest::qWaitFor([&] { return banner->whole_text().contains("refused"); }, 10'000));
    QVERIFY(banner->whole_text().startsWith("No connection to ws://127.0.0.1:1: "));
    QCOMPARE(dashboard.operators().status().state, RunState::no_run);
  }

  void the_first_start_says_what_to_do_next() {
    StartPage start;
    start.show();
    for (const char* name : {"open_demo", "open_script", "connect", "open_log"}) {
      auto* button = start.findChild<QAbstractButton*>(name);
      QVERIFY(button != nullptr);
      QVERIFY(!button->accessibleName().isEmpty());
    }
    QVERIFY(shipped_script("nothing.lua").isEmpty());
  }
};

QTEST_MAIN(TestWindow)
#include "tst_window.moc"
