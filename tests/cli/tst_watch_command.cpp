// SPDX-License-Identifier: Apache-2.0
// `trocar watch` as people call it, at a real `trocar run --serve`.
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include "tests/cli/trocar_process.hpp"

using namespace trocar::test;

namespace {

/// A served run of the demo in real time.
class Served {
 public:
  Served() {
    process_.setReadChannel(QProcess::StandardError);
    process_.start(TROCAR_BINARY,
                   {"run", TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua", "--serve",
                    "127.0.0.1:0", "--clock", "realtime", "--for", "60s", "--black-box", "off"});
    while (process_.waitForReadyRead(60'000)) {
      said_ += process_.readAllStandardError();
      const auto match = QRegularExpression("serving (ws://\\S+)").match(said_);
      if (!match.hasMatch()) continue;
      url_ = match.captured(1);
      return;
    }
  }
  ~Served() {
    process_.terminate();
    process_.waitForFinished(60'000);
  }
  const QString& url() const { return url_; }

 private:
  QProcess process_;
  QByteArray said_;
  QString url_;
};

}  // namespace

class TestWatchCommand : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_run_is_listed_told_and_stopped() {
    Served served;
    QVERIFY(!served.url().isEmpty());
    const Ran listed = run_trocar({"watch", served.url(), "--list", "--signals", "wall.*"});
    QCOMPARE(listed.status, 0);
    QVERIFY2(listed.out.startsWith("wall.force.x "), listed.out);
    QVERIFY2(!listed.out.contains("laparoscope"), listed.out);

    const Ran told = run_trocar(
        {"watch", served.url(), "--json", "--signals", "tick", "--interval", "0.2", "--for", "2"});
    QCOMPARE(told.status, 0);
    qint64 tick = -1;
    for (const QByteArray& line : told.out.trimmed().split('\n')) {
      const QJsonObject json = QJsonDocument::fromJson(line).object();
      QVERIFY2(json.contains("type"), line);
      if (json["type"] != "values") continue;
      QVERIFY(json["tick"].toInteger() > tick);
      tick = json["tick"].toInteger();
    }
    QVERIFY(tick > 0);

    const Ran stopped = run_trocar({"watch", served.url(), "--stop"});
    QCOMPARE(stopped.status, 0);
    QVERIFY2(stopped.out.startsWith("STOPPED, confirmed after "), stopped.out);
  }

  void what_is_wrong_is_said_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("text");
    QTest::newRow("no address of a stream")
        << QStringList{"http://x"} << 2 << "is no address of a live stream";
    QTest::newRow("listed and stopped") << QStringList{"--list", "--stop"} << 2 << "--stop";
    QTest::newRow("too often") << QStringList{"--interval", "0"} << 2 << "0.05";
    QTest::newRow("nobody there") << QStringList{"127.0.0.1:1", "--stop"} << 1
                                  << "nobody answers at ws://127.0.0.1:1";
  }
  void what_is_wrong_is_said() {
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    QFETCH(QString, text);
    const Ran outcome = run_trocar(QStringList{"watch"} + arguments);
    QCOMPARE(outcome.status, status);
    QVERIFY2(outcome.err.contains(text.toUtf8()), outcome.err);
  }
};

QTEST_GUILESS_MAIN(TestWatchCommand)
#include "tst_watch_command.moc"
