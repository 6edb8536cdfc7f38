// SPDX-License-Identifier: Apache-2.0
// What clients of the live stream may do: parameters, services, and who is let.
#include <QDir>
#include <QTemporaryDir>

#include "framework/recording/mcap_reader.hpp"
#include "tests/support/size_limit.hpp"
#include "tests/support/stream_rig.hpp"

using namespace trocar;
using namespace trocar::test;

class TestStreamControl : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;

  static double parameter(const StreamClient& client, const char* name) {
    for (const QJsonValue& one : client.last("parameterValues")["parameters"].toArray())
      if (one["name"] == name) return one["value"].toDouble(-1.0);
    return -1.0;
  }

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(folder_.path())); }

  void a_parameter_is_read_set_and_watched() {
    StreamRig rig;
    StreamClient client(rig.url()), other(rig.url());
    QVERIFY(client.open() && other.open());
    rig.run();
    other.send(stream::watch_parameters_text({.names = {"meter.gain"}, .on = true}));
    QVERIFY(other.wait([&] { return !other.last("advertiseServices").isEmpty(); }));
    client.send(stream::get_parameters_text({.names = {"meter.gain"}, .id = "1"}));
    QVERIFY(client.wait([&] { return client.last("parameterValues")["id"] == "1"; }));
    QCOMPARE(parameter(client, "meter.gain"), 2.0);
    client.send(stream::set_parameters_text({.values = {{"meter.gain", 4.0}}, .id = "2"}));
    QVERIFY(client.wait([&] { return client.last("parameterValues")["id"] == "2"; }));
    QCOMPARE(parameter(client, "meter.gain"), 4.0);
    QVERIFY(other.wait([&] { return parameter(other, "meter.gain") == 4.0; }));
    client.send(stream::set_parameters_text(
        {.values = {{"meter.gain", std::string("4500 mN")}}, .id = "3"}));
    QVERIFY(client.wait([&] { return parameter(client, "meter.gain") == 4.5; }));
    client.send(stream::get_parameters_text({.names = {}, .id = "4"}));
    QVERIFY(client.wait([&] { return client.last("parameterValues")["id"] == "4"; }));
    QVERIFY(client.last("parameterValues")["parameters"].toArray().size() > 3);
    client.call("end");
  }

  void a_log_of_the_run_that_fails_is_told_and_the_run_goes_on() {
    StreamRig rig;
    StreamClient client(rig.url());
    QVERIFY(client.open());
    rig.record("trial.mcap");
    QVERIFY(client.subscribe("/trocar/state", 7));
    QVERIFY(client.wait([&] { return client.json(7)["log"] == "trial.mcap"; }));
    QCOMPARE(client.json(7)["log_trouble"].toString(), QString());
    {
      const SizeLimit full(4096);  // no file may grow any more
      QVERIFY(client.wait([&] { return client.statuses().contains("recording failed: "); }));
    }
    QVERIFY2(client.statuses().contains("cannot write 'trial.mcap'"),
             qPrintable(client.statuses()));
    QVERIFY(client.wait([&] { return client.json(7)["log_trouble"] != QString(); }));
    const double time = client.json(7)["time"].toDouble();
    QVERIFY(client.wait([&] { return client.json(7)["time"].toDouble() > time + 0.3; }));
    QVERIFY(client.json(7)["log_trouble"].toString().contains("trial.mcap"));  // who comes later
    QVERIFY(client.json(7)["running"].toBool());
    client.call("end");
  }

  void what_does_not_fit_is_explained() {
    StreamRig rig;
    StreamClient client(rig.url());
    QVERIFY(client.open());
    rig.run();
    client.send(stream::set_parameters_text(
        {.values = {{"meter.gane", 4.0}, {"meter.gain", 40.0}, {"meter.fixed", 1.0}}, .id = "1"}));
    QVERIFY(client.wait([&] { return !client.statuses().isEmpty(); }));
    const QString statuses = client.statuses();
    QVERIFY2(statuses.contains("did you mean \"meter.gain\"?"), qPrintable(statuses));
    QVERIFY2(statuses.contains("at most 9 N"), qPrintable(statuses));
    QVERIFY2(statuses.contains("cannot be edited while it runs"), qPrintable(statuses));
    QCOMPARE(parameter(client, "meter.gain"), 2.0);
    client.call("end");
  }

  void services_are_called() {
    StreamRig rig;
    StreamClient client(rig.url());
    QVERIFY(client.open());
    rig.run();
    QVERIFY(client.subscribe("/events", 1));
    for (const char* service : {"engage", "stop", "acknowledge", "home"})
      QCOMPARE(client.call(service)["asked"].toString(), QString(service));
    QCOMPARE(client.call("annotate", "{\"text\":\"the gel is dry\"}")["asked"].toString(),
             QString("annotate"));
    QVERIFY(client.wait([&] {
      return std::any_of(client.messages[1].begin(), client.messages[1].end(),
                         [](const auto& one) { return one.content.contains("the gel is dry"); });
    }));
    const QJsonArray parameters = client.call("parameters")["parameters"].toArray();
    const auto gain = std::find_if(parameters.begin(), parameters.end(), [](const auto& one) {
      return one.toObject()["name"] == "meter.gain";
    });
    QVERIFY(gain != parameters.end());
    QCOMPARE(gain->toObject()["unit"].toString(), QString("N"));
    QCOMPARE(gain->toObject()["max"].toDouble(), 9.0);
    QVERIFY(gain->toObject()["min"].isNull());
    QVERIFY(gain->toObject()["live"].toBool());
    QVERIFY(client.call("annotate")["failure"].toString().contains("\"text\" is missing"));
    QVERIFY(client.call("annotate", "[]")["failure"].toString().contains("a JSON object"));
    QVERIFY(client.call("reload")["failure"].toString().contains("no component's law"));
    client.call("end");
  }

  void a_recording_is_begun_and_ended() {
    StreamRig rig;
    StreamClient client(rig.url());
    QVERIFY(client.open());
    rig.run();
    QVERIFY(client.subscribe("/trocar/state", 1));
    QVERIFY(client.call("record", "{\"on\":false}")["failure"].toString().contains("nothing"));
    QVERIFY(client.call("record", "{\"file\":\"../a.mcap\"}")["failure"].toString().contains(
        "without a folder"));
    QCOMPARE(client.call("record")["file"].toString(), QString("recording_1.mcap"));
    QVERIFY(client.call("record")["failure"].toString().contains("being recorded already"));
    QVERIFY(client.wait([&] {
      return !client.messages[1].empty() &&
             client.messages[1].back().content.contains(
                 "\"file\":\"recording_1.mcap\",\"rows\":") &&
             !client.messages[1].back().content.contains("\"rows\":0");
    }));
    const QJsonObject done = client.call("record", "{\"on\":false}");
    QCOMPARE(done["file"].toString(), QString("recording_1.mcap"));
    QCOMPARE(client.call("record", "{\"file\":\"recording_1.mcap\"}")["failure"].toString(),
             QString("\"recording_1.mcap\" exists already, and is kept"));
    client.call("end");
    rig.loop.join();
    const McapReader log("recording_1.mcap");
    const auto main = std::find_if(log.channels().begin(), log.channels().end(),
                                   [](const auto& one) { return one.second.topic == "/main"; });
    QVERIFY(main != log.channels().end());
    int rows = 0;
    log.messages([&](const McapMessage& message) { rows += message.channel == main->first; });
    QVERIFY(rows > 0);
    QCOMPARE(rows, done["rows"].toInt());
  }

  void who_may_only_look_can_still_stop_data() {
    QTest::addColumn<QString>("query");
    QTest::addColumn<QString>("origin");
    QTest::addColumn<bool>("may");
    QTest::newRow("a program here") << ""
                                    << "" << true;
    QTest::newRow("a page") << ""
                            << "https://example.com" << false;
    QTest::newRow("a page of this machine") << ""
                                            << "http://localhost:8080" << false;
    QTest::newRow("a page with the token") << "?token=secret"
                                           << "https://example.com" << true;
    QTest::newRow("a wrong token") << "?token=sekret"
                                   << "" << false;
    QTest::newRow("a page with a wrong token") << "?token="
                                               << "https://example.com" << false;
  }
  void who_may_only_look_can_still_stop() {
    QFETCH(QString, query);
    QFETCH(QString, origin);
    QFETCH(bool, may);
    StreamRig rig(ServiceType::Settings{{"token", "secret"}});
    StreamClient client(rig.url(query), origin);
    QVERIFY(client.open());
    rig.run();
    QVERIFY(client.subscribe("/main", 1));
    QVERIFY(client.wait([&] { return client.messages[1].size() > 10; }));
    client.send(stream::set_parameters_text({.values = {{"meter.gain", 4.0}}, .id = "1"}));
    if (may)
      QVERIFY(client.wait([&] { return parameter(client, "meter.gain") == 4.0; }));
    else
      QVERIFY(client.wait([&] { return client.statuses().contains("needs the token"); }));
    QCOMPARE(client.call("engage").contains("failure"), !may);
    QCOMPARE(client.call("record", "{\"file\":\"x\"}")["failure"].toString().contains("token"),
             !may);
    QCOMPARE(client.call("stop")["asked"].toString(), QString("stop"));
    rig.stop.raise();
  }

  void without_a_run_requests_are_refused() {
    StreamRig rig;
    StreamClient client(rig.url());
    QVERIFY(client.open());
    QVERIFY(client.call("stop")["failure"].toString().contains("no run takes requests"));
    client.send(stream::get_parameters_text({.names = {}, .id = "1"}));
    QVERIFY(client.wait([&] { return client.statuses().contains("no run takes requests"); }));
  }

  void a_run_can_wait_for_its_start() {
    StreamRig rig(ServiceType::Settings{{"wait", "true"}});
    StreamClient client(rig.url());
    QVERIFY(client.open());
    QVERIFY(client.subscribe("/trocar/state", 1));
    rig.run();
    QVERIFY(client.wait([&] { return client.messages[1].size() > 3; }));
    QVERIFY(client.channel("/main").isEmpty());
    QCOMPARE(client.call("start")["asked"].toString(), QString("start"));
    QVERIFY(client.subscribe("/main", 2));
    QVERIFY(client.wait([&] { return client.messages[2].size() > 10; }));
    client.call("end");
  }
};

QTEST_GUILESS_MAIN(TestStreamControl)
#include "tst_stream_control.moc"
