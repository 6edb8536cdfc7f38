// SPDX-License-Identifier: Apache-2.0
// What clients of the live stream see of runs, over real sockets.
#include "framework/recording/ros2_decode.hpp"
#include "framework/stream/batch.hpp"
#include "tests/support/stream_rig.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

Ros2Decoder decoder_of(const QJsonObject& channel) {
  return {channel["schemaName"].toString().toStdString(),
          channel["schema"].toString().toStdString()};
}

}  // namespace

class TestStream : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_client_is_welcomed_data() {
    QTest::addColumn<QString>("protocol");
    QTest::newRow("new name") << "foxglove.sdk.v1";
    QTest::newRow("old name") << "foxglove.websocket.v1";
  }
  void a_client_is_welcomed() {
    QFETCH(QString, protocol);
    StreamRig rig;
    StreamClient client(rig.url(), {}, protocol);
    QVERIFY(client.open());
    QCOMPARE(client.socket().subprotocol(), protocol);
    QVERIFY(client.wait([&] { return !client.last("advertiseServices").isEmpty(); }));
    const QJsonObject info = client.last("serverInfo");
    QCOMPARE(info["name"].toString(), QString("Trocar"));
    QVERIFY(info["capabilities"].toArray().contains("parameters"));
    QCOMPARE(info["metadata"]["write"].toString(), QString("yes"));
    QVERIFY(!client.channel("/events").isEmpty());
    QVERIFY(!client.channel("/trocar/state").isEmpty());
  }

  void every_row_arrives_as_it_was_in_both_forms() {
    StreamRig rig;
    StreamClient client(rig.url());
    rig.begin();
    QVERIFY(client.subscribe("/main", 1));
    QVERIFY(client.subscribe("/main/batch", 2));
    QVERIFY(client.subscribe("/main/preview", 3));
    QVERIFY(client.subscribe("/trocar/state", 4));
    QVERIFY(client.wait([&] { return !client.messages[4].empty(); }));  // all is subscribed
    constexpr std::int64_t count = 2000;
    rig.feed(0, count);
    rig.end();
    std::vector<QByteArray> batched;
    std::size_t taken = 0;
    QVERIFY(client.wait([&] {
      for (; taken < client.messages[2].size(); ++taken)
        for (const auto row :
             stream::Batch::rows(client.messages[2][taken].bytes(), rig.layouts.front().size()))
          batched.emplace_back(reinterpret_cast<const char*>(row.data()),
                               static_cast<qsizetype>(row.size()));
      return client.messages[1].size() == count && batched.size() == count;
    }));
    for (std::int64_t tick = 0; tick < count; ++tick) {
      const std::vector<std::byte> row = rig.row(tick);
      const QByteArray expected(reinterpret_cast<const char*>(row.data()),
                                static_cast<qsizetype>(row.size()));
      const StreamClient::Message& single = client.messages[1][static_cast<std::size_t>(tick)];
      QCOMPARE(single.time_ns, static_cast<std::uint64_t>(tick) * 1'000'000);
      QCOMPARE(single.content, QByteArray("\0\1\0\0", 4) + expected);
      QCOMPARE(batched[static_cast<std::size_t>(tick)], expected);
    }
    const Ros2Decoder preview = decoder_of(client.channel("/main/preview"));
    QVERIFY(client.wait([&] { return client.messages[3].size() >= 60; }));
    const Ros2Leaf* last = preview.find("tick.last");
    QCOMPARE(as_double(preview.value(client.messages[3].back().bytes(), *last)), count - 1.0);
  }

  void channels_of_a_run_go_when_the_next_begins() {
    StreamRig rig;
    StreamClient client(rig.url());
    rig.begin();
    QVERIFY(client.subscribe("/main", 1));
    const int first = client.channel("/main")["id"].toInt();
    rig.feed(0, 10);
    rig.end();
    QVERIFY(client.wait([&] { return client.messages[1].size() == 10; }));
    rig.begin();
    QVERIFY(client.wait([&] { return client.channel("/main")["id"].toInt() != first; }));
    QVERIFY(client.last("unadvertise")["channelIds"].toArray().contains(first));
    QVERIFY(client.subscribe("/main", 1));  // the number is free again
    QVERIFY(client.subscribe("/trocar/state", 2));
    QVERIFY(client.wait([&] { return !client.messages[2].empty(); }));
    rig.feed(0, 5);
    rig.end();
    QVERIFY(client.wait([&] { return client.messages[1].size() == 15; }));
  }

  /// As experiments have them, in virtual time: the newest is seen, under its number.
  void very_many_short_runs_do_not_pile_up() {
    StreamRig rig;
    StreamClient client(rig.url());
    QVERIFY(client.subscribe("/trocar/state", 1));
    constexpr int count = 300;
    for (int i = 0; i < count; ++i) {
      rig.begin();
      rig.feed(0, 3);
      if (i < count - 1) rig.end();
    }
    QVERIFY(client.wait([&] {
      return !client.messages[1].empty() &&
             client.messages[1].back().content.contains("{\"run\":300,\"running\":true");
    }));
    QVERIFY(client.subscribe("/main", 2));
    QVERIFY(client.subscribe("/trocar/state", 3));
    QVERIFY(client.wait([&] { return !client.messages[3].empty(); }));
    rig.feed(3, 8);
    rig.end();
    QVERIFY(client.wait([&] { return client.messages[2].size() == 5; }));
    QVERIFY2(client.messages[3].front().content.contains("\"time\":0.0"),
             client.messages[3].front().content);
  }

  void who_comes_later_is_told_what_happened() {
    StreamRig rig;
    rig.begin();
    rig.service.rows().event(0, {.kind = Event::Kind::fault,
                                 .tick = 7,
                                 .time_ns = 7'000'000,
                                 .source = "arm",
                                 .what = "speed",
                                 .detail = "handle",
                                 .value = 2.0,
                                 .limit = 1.0});
    StreamClient client(rig.url());
    QVERIFY(client.subscribe("/events", 1));
    QVERIFY(client.wait([&] { return client.messages[1].size() == 1; }));
    const Ros2Decoder decoder = decoder_of(client.channel("/events"));
    QMap<QString, QString> event;
    decoder.visit(client.messages[1][0].bytes(), [&](const Ros2Leaf& leaf, const Ros2Value& value) {
      if (const auto* text = std::get_if<std::string_view>(&value))
        event[QString::fromStdString(leaf.path)] = QString::fromStdString(std::string(*text));
    });
    QCOMPARE(event["kind"], QString("fault"));
    QCOMPARE(event["source"], QString("arm"));
    QCOMPARE(event["detail"], QString("speed: handle"));
    QCOMPARE(event["thread"], QString("main"));
    rig.end();
  }

  void the_graph_is_told() {
    StreamRig rig;
    rig.begin();
    StreamClient client(rig.url());
    QVERIFY(client.open());
    QVERIFY(client.subscribe("/main", 1));
    client.send(stream::watch_graph_text({true}));
    QVERIFY(client.wait([&] { return !client.last("connectionGraphUpdate").isEmpty(); }));
    QStringList topics;
    for (const QJsonValue& one : client.last("connectionGraphUpdate")["publishedTopics"].toArray())
      topics << one["name"].toString();
    QVERIFY2(topics.contains("meter.force"), qPrintable(topics.join(' ')));
    rig.end();
  }

  void a_run_in_real_time_is_streamed() {
    StreamRig rig;
    StreamClient client(rig.url());
    QVERIFY(client.open());
    rig.run();
    QVERIFY(client.subscribe("/main", 1));
    QVERIFY(client.wait([&] { return client.messages[1].size() > 300; }));
    QCOMPARE(client.call("end")["asked"].toString(), QString("end"));
    rig.loop.join();
    const Ros2Decoder decoder = decoder_of(client.channel("/main"));
    const auto value = [&](const StreamClient::Message& message, const char* path) {
      return as_double(decoder.value(message.bytes(), *decoder.find(path)));
    };
    // What the stream has of a tick is what the run has of it.
    const std::vector<double> kept = rig.result.rows->column(*rig.result.rows->find("meter.value"));
    for (const StreamClient::Message& message : client.messages[1]) {
      const double tick = value(message, "tick");
      QCOMPARE(value(message, "meter.value"), 2.0 + tick);
      QVERIFY(message.time_ns > 1'700'000'000'000'000'000u);
    }
    QVERIFY(kept.size() >= client.messages[1].size());
    QVERIFY(client.time_ns > 0);
    QVERIFY(rig.result.missed.empty());
  }
};

QTEST_GUILESS_MAIN(TestStream)
#include "tst_stream.moc"
