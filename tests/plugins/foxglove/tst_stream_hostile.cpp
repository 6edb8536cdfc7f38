// SPDX-License-Identifier: Apache-2.0
// Clients that do harm, or nothing: the others are served, and memory stays bounded.
#include <QTcpSocket>
#include <fstream>
#include <limits>
#include <memory>

#include "tests/support/stream_rig.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

/// [MiB] of this process. AddressSanitizer keeps what was freed, so that it tells nothing there.
double resident() {
#ifdef __SANITIZE_ADDRESS__
  return 0.0;
#endif
  std::ifstream file("/proc/self/statm");
  long pages = 0, kept = 0;
  file >> pages >> kept;
  return static_cast<double>(kept) * 4096.0 / 1048576.0;
}

QByteArray handshake(quint16 port) {
  return "GET / HTTP/1.1\r\nHost: 127.0.0.1:" + QByteArray::number(port) +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: "
         "dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: "
         "foxglove.sdk.v1\r\n\r\n";
}

/// A text in a frame of a client.
QByteArray frame(const QByteArray& text) {
  QByteArray frame("\x81", 1);
  frame += static_cast<char>(0x80 | text.size());
  frame += QByteArray(4, '\0');  // a mask that changes nothing
  return frame + text;
}

}  // namespace

class TestStreamHostile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nonsense_is_answered_and_the_next_message_is_served() {
    StreamRig rig;
    StreamClient client(rig.url());
    rig.begin();
    QVERIFY(client.open());
    client.send("{");
    client.send("{\"op\":\"subscribe\",\"subscriptions\":[{\"id\":1,\"channelId\":999}]}");
    client.send("{\"op\":\"advertise\",\"channels\":[]}");
    client.socket().sendBinaryMessage("\7\0\0");
    QVERIFY(client.wait([&] { return client.statuses().contains("begins with 7"); }));
    for (const char* part : {"not JSON", "no channel 999", "\"advertise\" is not offered"})
      QVERIFY2(client.statuses().contains(part), qPrintable(client.statuses()));
    QVERIFY(client.subscribe("/main", 1));
    QVERIFY(client.subscribe("/main", 1));  // twice
    QVERIFY(client.wait([&] { return client.statuses().contains("a subscription 1 already"); }));
    rig.feed(0, 10);
    QVERIFY(client.wait([&] { return client.messages[1].size() == 10; }));
    rig.end();
  }

  void a_flood_is_cut_off() {
    StreamRig rig;
    StreamClient flood(rig.url()), other(rig.url());
    QVERIFY(flood.open() && other.open());
    for (int i = 0; i < 5000; ++i) flood.send("{\"op\":\"unsubscribeConnectionGraph\"}");
    QVERIFY(flood.closed());
    QVERIFY(flood.socket().closeReason().contains("too many messages"));
    rig.begin();
    QVERIFY(other.subscribe("/events", 1));
    rig.end();
  }

  void a_message_that_is_too_long_is_cut_off() {
    StreamRig rig;
    StreamClient client(rig.url());
    QVERIFY(client.open());
    client.send(std::string(300 * 1024, ' '));
    QVERIFY(client.closed());
    StreamClient other(rig.url());
    QVERIFY(other.open());
  }

  void a_client_of_another_protocol_is_refused() {
    StreamRig rig;
    StreamClient client(rig.url(), {}, "mqtt"), plain(rig.url(), {}, "");
    QVERIFY(client.closed() && plain.closed());
    StreamClient good(rig.url());
    QVERIFY(good.open());
  }

  void too_many_are_refused_and_the_first_are_served() {
    StreamRig rig;
    rig.begin();
    std::vector<std::unique_ptr<StreamClient>> crowd;
    for (int i = 0; i < 64; ++i) {
      crowd.push_back(std::make_unique<StreamClient>(rig.url()));
      QVERIFY(crowd.back()->open());
      QVERIFY(crowd.back()->subscribe("/main", 1));
    }
    StreamClient late(rig.url());
    QVERIFY(late.closed());
    QVERIFY2(late.socket().closeReason().contains("64 clients"),
             qPrintable(late.socket().closeReason()));
    QVERIFY(crowd.back()->subscribe("/trocar/state", 2));
    QVERIFY(crowd.back()->wait([&] { return !crowd.back()->messages[2].empty(); }));
    rig.feed(0, 20);
    for (auto& one : crowd) QVERIFY(one->wait([&] { return one->messages[1].size() == 20; }));
    crowd.erase(crowd.begin());
    StreamClient now(rig.url());
    QVERIFY(now.open());
    QVERIFY(now.subscribe("/main", 1));
    rig.end();
  }

  /// A thousand, of which most never say a word.
  void a_thousand_connections_leave_room() {
    StreamRig rig;
    const double before = resident();
    std::vector<std::unique_ptr<QTcpSocket>> crowd;
    for (int i = 0; i < 1000; ++i) {
      crowd.push_back(std::make_unique<QTcpSocket>());
      crowd.back()->connectToHost("127.0.0.1", rig.service.endpoint().port);
      if (i % 50 == 0) QTest::qWait(1);
    }
    QTest::qWait(200);
    const double grown = resident() - before;
    QVERIFY2(grown < 64.0, qPrintable(QString::number(grown) + " MiB"));
    crowd.clear();
    StreamClient client(rig.url());
    QVERIFY(client.open());
  }

  /// What it does not fetch is dropped, it is told, and the others lose nothing.
  void a_client_that_does_not_fetch_costs_little() {
    StreamRig rig;
    rig.begin();
    StreamClient good(rig.url());
    QVERIFY(good.subscribe("/main", 1));
    const auto number = good.channel("/main")["id"].toInt();
    QTcpSocket lazy;
    lazy.connectToHost("127.0.0.1", rig.service.endpoint().port);
    QVERIFY(lazy.waitForConnected());
    lazy.write(handshake(rig.service.endpoint().port));
    QVERIFY(good.wait([&] { return lazy.peek(4096).contains("101 Switching"); }));
    lazy.setReadBufferSize(1);
    lazy.write(frame("{\"op\":\"subscribe\",\"subscriptions\":[{\"id\":1,\"channelId\":" +
                     QByteArray::number(number) + "}]}"));
    QVERIFY(lazy.flush());
    QVERIFY(good.subscribe("/trocar/state", 2));
    QVERIFY(good.wait([&] { return good.messages[2].size() > 2; }));
    const double before = resident();
    std::size_t fed = 0, forgotten = 0;
    // 60 MB of rows.
    const std::size_t rows = 60'000'000 / rig.layouts.front().size();
    while (fed < rows) {
      rig.feed(static_cast<std::int64_t>(fed), static_cast<std::int64_t>(fed + 5000));
      fed += 5000;
      QVERIFY(good.wait([&] { return forgotten + good.messages[1].size() == fed; }));
      forgotten += good.messages[1].size();
      good.messages[1].clear();
    }
    const double grown = resident() - before;
    QVERIFY2(grown < 48.0, qPrintable(QString::number(grown) + " MiB"));
    lazy.setReadBufferSize(0);
    QByteArray seen;
    QVERIFY(good.wait([&] {
      seen = (seen + lazy.readAll()).right(100'000);
      return seen.contains("were dropped: this client fetched them too slowly");
    }));
    rig.end();
  }

  void settings_that_do_not_fit_are_explained_data() {
    QTest::addColumn<QString>("address");
    for (const char* address :
         {"here", "300.1.1.1:80", "1.2.3", "::g", "1.2.3.4:x", "127.0.0.1:70000", "[::1", "a b:1"})
      QTest::newRow(address) << address;
  }
  void settings_that_do_not_fit_are_explained() {
    QFETCH(QString, address);
    QString said;
    try {
      foxglove::FoxgloveService({{"address", address.toStdString()}});
    } catch (const std::invalid_argument& error) {
      said = error.what();
    }
    QVERIFY2(said.contains("no address to listen at"), qPrintable(said));
  }

  void an_address_in_use_is_said() {
    StreamRig rig;
    QString said;
    try {
      foxglove::FoxgloveService({{"address", std::to_string(rig.service.endpoint().port)}});
    } catch (const std::runtime_error& error) {
      said = error.what();
    }
    QVERIFY2(said.contains("in use"), qPrintable(said));
  }
};

QTEST_GUILESS_MAIN(TestStreamHostile)
#include "tst_stream_hostile.moc"
