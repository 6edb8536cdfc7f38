// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/pipe_link.hpp"

#include <QTest>
#include <algorithm>
#include <array>
#include <stdexcept>

using namespace trocar::hid;

namespace {

Report filled(std::uint8_t value) {
  Report report;
  report.fill(value);
  return report;
}

}  // namespace

class TestPipeLink : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void reports_arrive_whole_and_in_order() {
    const auto [host, device] = PipeLink::make_pair();
    std::array<std::uint8_t, report_size + 1> bytes{};
    QCOMPARE(host->read(bytes, 0), 0);
    QVERIFY(device->write(filled(1)));
    QVERIFY(device->write(ReportBytes(filled(2)).first(10)));
    QVERIFY(device->write(std::array<std::uint8_t, 100>{}));
    QCOMPARE(host->read(bytes, 0), 64);
    QCOMPARE(bytes[63], std::uint8_t{1});
    QCOMPARE(host->read(bytes, 0), 10);
    QVERIFY2(host->read(bytes, 0) == 65, "longer than a report, and seen to be");
    QCOMPARE(host->read(bytes, 0), 0);
  }

  void both_ends_can_be_had_twice() {
    const auto [host, device] = PipeLink::make_pair();
    const auto second = host->second();
    std::array<std::uint8_t, report_size + 1> bytes{};
    QVERIFY(second->write(filled(3)));
    QCOMPARE(device->read(bytes, 0), 64);
    QCOMPARE(bytes[0], std::uint8_t{3});
  }

  void an_end_that_is_gone_is_told() {
    auto [host, device] = PipeLink::make_pair();
    std::array<std::uint8_t, report_size + 1> bytes{};
    QVERIFY(device->write(filled(4)));
    device.reset();
    QVERIFY2(host->read(bytes, 0) == 64, "what was sent before is still there");
    QCOMPARE(host->read(bytes, 0), Link::gone);
    QVERIFY(!host->write(filled(5)));
  }

  void what_nobody_takes_is_lost_and_nobody_waits() {
    const auto [host, device] = PipeLink::make_pair();
    for (int i = 0; i < 10'000; ++i) QVERIFY(device->write(filled(6)));
    std::array<std::uint8_t, report_size + 1> bytes{};
    int arrived = 0;
    while (host->read(bytes, 0) > 0) ++arrived;
    QVERIFY(arrived > 10 && arrived < 10'000);
  }

  void a_socket_where_nobody_listens_is_refused_with_the_cure() {
    try {
      SocketSource("/nowhere/emulated.sock").open();
      QFAIL("opened");
    } catch (const std::runtime_error& error) {
      const std::string said = error.what();
      QVERIFY(said.find("/nowhere/emulated.sock") != std::string::npos);
      QVERIFY(said.find("start an emulated device") != std::string::npos);
    }
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, PipeLink::connect(std::string(200, 'x')));
  }
};

QTEST_APPLESS_MAIN(TestPipeLink)
#include "tst_pipe_link.moc"
