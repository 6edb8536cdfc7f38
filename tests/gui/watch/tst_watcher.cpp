// SPDX-License-Identifier: Apache-2.0
// What `trocar watch` says of a run, over real sockets.
#include "gui/watch/watcher.hpp"

#include <QSignalSpy>

#include "tests/support/stream_rig.hpp"

using namespace trocar;
using namespace trocar::gui;
using trocar::test::StreamRig;

namespace {

struct Listener {
  explicit Listener(WatchOptions options)
      : watcher(
            std::move(options), [this](const std::string& line) { said.push_back(line); },
            [this](const std::string& line) { complaints.push_back(line); }),
        done(&watcher, &Watcher::done) {}

  bool wait(const std::function<bool()>& until) { return QTest::qWaitFor(until, 10'000); }
  bool leaves() {
    return wait([&] { return !done.empty(); });
  }
  int status() const { return done.front().front().toInt(); }
  /// The first line that is an object of that type.
  nlohmann::json find(const std::string& type) const {
    for (const std::string& line : said)
      if (nlohmann::json json = nlohmann::json::parse(line); json["type"] == type) return json;
    return {};
  }

  std::vector<std::string> said, complaints;
  Watcher watcher;
  QSignalSpy done;
};

bool any_contains(const std::vector<std::string>& lines, const std::string& text) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

}  // namespace

class TestWatcher : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void signals_are_listed_once() {
    StreamRig rig;
    rig.run();
    Listener listener({.form = WatchOptions::Form::lines, .list = true});
    listener.watcher.open(QUrl(rig.url()));
    QVERIFY(listener.leaves());
    QCOMPARE(listener.status(), 0);
    for (const RowPort& port : rig.layouts.front().ports())
      QVERIFY2(any_contains(listener.said, port.name), port.name.c_str());
    QVERIFY(!any_contains(listener.said, "lateness"));
  }

  void json_lines_say_what_the_rows_say() {
    StreamRig rig;
    Listener listener({.form = WatchOptions::Form::json, .patterns = {"*"}, .interval = 0.05});
    listener.watcher.open(QUrl(rig.url()));
    QVERIFY(listener.wait([&] { return listener.find("link")["state"] == "connecting"; }));
    rig.begin();
    QVERIFY(listener.wait([&] { return listener.find("state")["running"] == true; }));
    rig.feed(0, 1000);
    rig.end();
    QVERIFY(listener.wait([&] { return !listener.find("values").is_null(); }));
    QVERIFY(listener.wait([&] {
      const nlohmann::json last = nlohmann::json::parse(listener.said.back());
      return last["type"] == "values" && last["tick"] == 999;
    }));
    const nlohmann::json last = nlohmann::json::parse(listener.said.back());
    QCOMPARE(last["time"].get<double>(), 0.999);
    QCOMPARE(last["signals"]["tick"]["last"].get<double>(), 999.0);
    QVERIFY(last["signals"]["tick"]["min"].get<double>() <= 999.0);
  }

  void stop_is_confirmed_by_the_device_and_not_by_the_answer() {
    StreamRig rig;
    rig.run();
    Listener listener({.form = WatchOptions::Form::json, .stop = true});
    listener.watcher.open(QUrl(rig.url()));
    QVERIFY(listener.leaves());
    QCOMPARE(listener.status(), 0);
    QCOMPARE(listener.find("stop")["confirmed"].get<bool>(), true);
    rig.stop.raise();
    rig.loop.join();
    QVERIFY(!rig.result.faults.empty());
  }

  void nobody_there_is_said() {
    for (const bool stop : {true, false}) {
      Listener listener({.form = WatchOptions::Form::lines, .list = !stop, .stop = stop});
      listener.watcher.open(QUrl("ws://127.0.0.1:1"));
      QVERIFY(listener.leaves());
      QCOMPARE(listener.status(), 1);
      QVERIFY(any_contains(listener.complaints, "nobody answers at ws://127.0.0.1:1"));
    }
  }

  void a_stop_is_confirmed_data() {
    QTest::addColumn<qint64>("tick");
    QTest::addColumn<bool>("rendering");
    QTest::addColumn<double>("at");
    QTest::addColumn<QString>("text");
    QTest::newRow("by a later row without rendering")
        << qint64{11} << false << 0.03 << "STOPPED, confirmed after 30 ms";
    QTest::newRow("not by a row that renders") << qint64{11} << true << 0.03 << "stopping";
    QTest::newRow("not by a row from before") << qint64{10} << false << 0.03 << "stopping";
    QTest::newRow("not within a quarter of a second")
        << qint64{11} << true << 0.3 << "NOT CONFIRMED: use the hardware switch";
    QTest::newRow("late, but then it is")
        << qint64{11} << false << 0.3 << "STOPPED, confirmed after 300 ms";
  }
  void a_stop_is_confirmed() {
    QFETCH(qint64, tick);
    QFETCH(bool, rendering);
    QFETCH(double, at);
    QFETCH(QString, text);
    StopCheck check;
    QCOMPARE(check.text(0.0), std::string());
    check.ask(1.0);
    check.saw(1.01, 100, false);  // before the runtime took the request
    QCOMPARE(check.text(1.01), std::string("stopping"));
    check.accepted(10);
    check.saw(1.0 + at, tick, rendering);
    QCOMPARE(QString::fromStdString(check.text(1.0 + at)), text);
  }

  void a_screen_fits_its_terminal() {
    StreamRig rig;
    rig.run();
    Listener listener({.form = WatchOptions::Form::screen, .interval = 0.05});
    listener.watcher.open(QUrl(rig.url()));
    QVERIFY(listener.wait([&] {
      const WatchView view = listener.watcher.view();
      return view.state.running && !view.threads.empty() && view.threads[0]->has_values();
    }));
    const std::string text = screen_text(listener.watcher.view(), 40, 10);
    QCOMPARE(std::count(text.begin(), text.end(), '\n'), 9);
    for (const QString& line : QString::fromStdString(text).split('\n'))
      QVERIFY2(line.size() <= 40 + 3, qPrintable(line));  // and what clears the rest of the line
    QVERIFY(text.find("more: --signals PATTERN chooses") != std::string::npos);
    listener.watcher.key('q');
    QVERIFY(listener.leaves());
    QCOMPARE(listener.status(), 0);
  }
};

QTEST_GUILESS_MAIN(TestWatcher)
#include "tst_watcher.moc"
