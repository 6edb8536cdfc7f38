// SPDX-License-Identifier: Apache-2.0
// Where the stream listens, and who may change anything.
#include "plugins/foxglove/access.hpp"

#include <QTest>

using namespace trocar::foxglove;

class TestAccess : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void addresses_are_read_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("url");
    QTest::addColumn<bool>("loopback");
    QTest::newRow("nothing") << ""
                             << "ws://127.0.0.1:8765" << true;
    QTest::newRow("port") << "9000"
                          << "ws://127.0.0.1:9000" << true;
    QTest::newRow("colon") << ":9000"
                           << "ws://127.0.0.1:9000" << true;
    QTest::newRow("name") << "localhost:1"
                          << "ws://127.0.0.1:1" << true;
    QTest::newRow("all") << "0.0.0.0"
                         << "ws://0.0.0.0:8765" << false;
    QTest::newRow("one") << "192.168.1.7:80"
                         << "ws://192.168.1.7:80" << false;
    QTest::newRow("six") << "[::1]:80"
                         << "ws://[::1]:80" << true;
    QTest::newRow("six without port") << "[fe80::1]"
                                      << "ws://[fe80::1]:8765" << false;
  }
  void addresses_are_read() {
    QFETCH(QString, text);
    QFETCH(QString, url);
    QFETCH(bool, loopback);
    const Endpoint endpoint = parse_endpoint(text.toStdString());
    QCOMPARE(QString::fromStdString(endpoint.url()), url);
    QCOMPARE(endpoint.loopback(), loopback);
  }

  void only_who_is_meant_may_write() {
    QVERIFY(may_write({.local = true}, "secret"));
    QVERIFY(!may_write({.local = false}, "secret"));
    QVERIFY(may_write({.local = false, .origin = {}, .token = "secret"}, "secret"));
    QVERIFY(!may_write({.local = true, .origin = "a page", .token = {}}, "secret"));
    QVERIFY(!may_write({.local = false, .origin = {}, .token = "secre"}, "secret"));
    QVERIFY(!may_write({.local = false, .origin = {}, .token = ""}, ""));
  }

  void tokens_differ() {
    QCOMPARE(random_token().size(), std::size_t{32});
    QVERIFY(random_token() != random_token());
  }
};

QTEST_GUILESS_MAIN(TestAccess)
#include "tst_access.moc"
