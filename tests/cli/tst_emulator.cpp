// SPDX-License-Identifier: Apache-2.0
#include "cli/emulator.hpp"

#include <sys/stat.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <deque>
#include <stdexcept>
#include <vector>

#include "components/devices/hid/pipe_link.hpp"

using namespace trocar;
using namespace trocar::cli;

namespace {

/// A host that sends what the test says and keeps what it gets.
class TestPort final : public DevicePort {
 public:
  std::size_t receive(std::span<std::uint8_t> into) override {
    if (to_device.empty()) return 0;
    std::copy(to_device.front().begin(), to_device.front().end(), into.begin());
    to_device.pop_front();
    return hid::report_size;
  }
  void send(const hid::Report& report) override { to_host.push_back(report); }
  void plug() override { ++plugged; }
  void unplug() override { ++unplugged; }

  std::deque<hid::Report> to_device;
  std::vector<hid::Report> to_host;
  int plugged = 0, unplugged = 0;
};

struct Bench {
  TestPort port;
  Emulator emulator{{}, port};

  void ms(int count) {
    for (int i = 0; i < 4 * count; ++i) emulator.cycle();
  }
  void ask_for_page() {
    hid::Report request;
    hid::encode(hid::PageRequest{hid::PageNumber::identity, 3}, request);
    port.to_device.push_back(request);
  }
};

}  // namespace

class TestEmulator : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void reports_go_out_and_requests_come_in() {
    Bench bench;
    bench.ms(10);
    QCOMPARE(bench.port.to_host.size(), std::size_t{10});
    bench.ask_for_page();
    bench.ms(1);
    QCOMPARE(bench.port.to_host.size(), std::size_t{12});
  }

  void orders_are_carried_out() {
    Bench bench;
    bench.emulator.obey("loss 100 %");
    bench.ms(10);
    QVERIFY(bench.port.to_host.empty());
    bench.emulator.obey("loss 0 %");
    bench.emulator.obey("  delay 5ms ");
    bench.ms(10);
    QCOMPARE(bench.port.to_host.size(), std::size_t{5});
    bench.emulator.obey("delay 0 s");
    bench.ms(10);
    bench.emulator.obey("stuck on");
    bench.ms(2);
    QVERIFY(bench.port.to_host.back() == bench.port.to_host.at(bench.port.to_host.size() - 2));
    bench.emulator.obey("stuck off");
    bench.ms(1);
    bench.emulator.obey("deaf on");
    bench.port.to_host.clear();
    bench.ask_for_page();
    bench.ms(1);
    QCOMPARE(bench.port.to_host.size(), std::size_t{1});
    bench.emulator.obey("jump 2 4000");
    bench.emulator.obey("heat 130");
    bench.emulator.obey("dead-man off");
    bench.ms(1);
    hid::StateReport state;
    QCOMPARE(decode(bench.port.to_host.back(), state), hid::ReportDefect::none);
    QCOMPARE(state.encoder[1], 4000);
    QCOMPARE(int{state.temperature[0]}, 170);
    QVERIFY(!state.dead_man);
    QCOMPARE(state.fault, hid::DeviceFault::temperature);
    QVERIFY(bench.emulator.obey("state").starts_with("fault of temperature, braked, tip 0.00"));
    QVERIFY(!bench.emulator.over());
    bench.emulator.obey("quit");
    QVERIFY(bench.emulator.over());
  }

  void unplugged_it_forgets() {
    Bench bench;
    bench.ms(100);
    const std::uint32_t before = bench.emulator.device().time_us();
    bench.emulator.obey("unplug");
    bench.emulator.obey("unplug");
    QCOMPARE(bench.port.unplugged, 1);
    bench.emulator.obey("plug");
    QCOMPARE(bench.port.plugged, 1);
    QVERIFY(bench.emulator.device().time_us() < before);
  }

  void mistakes_are_named_data() {
    QTest::addColumn<QString>("order");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* order, const char* said) {
      QTest::newRow(order) << order << said;
    };
    row("los 20%", "there is no order \"los\", did you mean \"loss\"?; possible are");
    row("loss 120%", "loss \"120%\": a share from 0 % to 100 % is needed");
    row("loss", "loss \"\": a share");
    row("delay 3", "delay \"3\": a time from 0 s to 10 s is needed");
    row("delay 1min", "a time from 0 s to 10 s");
    row("stuck maybe", "stuck \"maybe\": on or off is possible");
    row("jump 7 100", "jump: axis \"7\": a whole number from 1 to 6 is needed");
    row("jump 1", "jump: counts \"\": a whole number");
    row("heat 1000", "heat \"1000\": a whole number from -40 to 200");
  }
  void mistakes_are_named() {
    QFETCH(QString, order);
    QFETCH(QString, said);
    Bench bench;
    try {
      bench.emulator.obey(order.toStdString());
      QFAIL("taken");
    } catch (const std::invalid_argument& error) {
      QVERIFY2(QString(error.what()).contains(said), error.what());
    }
    QVERIFY(bench.emulator.obey("").empty());
  }

  void a_socket_takes_one_host() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("device.sock").toStdString();
    const auto port = socket_port(path);
    std::array<std::uint8_t, 100> bytes{};
    QCOMPARE(port->receive(bytes), std::size_t{0});
    hid::SocketSource source(path);
    const hid::LinkPair host = source.open();
    QVERIFY(host.out->write(hid::Report{1, 2, 3}));
    QCOMPARE(port->receive(bytes), std::size_t{64});
    QCOMPARE(int{bytes[2]}, 3);
    port->send(hid::Report{7});
    QCOMPARE(host.in->read(bytes, 0), 64);
    const hid::LinkPair second = source.open();
    port->receive(bytes);
    QCOMPARE(second.in->read(bytes, 0), hid::Link::gone);
    QCOMPARE(host.in->read(bytes, 0), 0);
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, socket_port(path));
    port->unplug();
    QCOMPARE(host.in->read(bytes, 0), hid::Link::gone);
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, source.open());
    port->plug();
    const hid::LinkPair again = source.open();
    QVERIFY(again.out->write(hid::Report{4}));
    QCOMPARE(port->receive(bytes), std::size_t{64});
  }

  void a_file_of_another_kind_is_left_alone() {
    const QTemporaryDir folder;
    QFile file(folder.filePath("device.sock"));
    QVERIFY(file.open(QFile::WriteOnly) && file.write("mine") == 4);
    file.close();
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, socket_port(file.fileName().toStdString()));
    QVERIFY(file.exists());
  }

  // A pipe in the file system gives back what was written, as a gadget's file does not.
  void a_gadgets_file_is_read_and_written() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("hidg0").toStdString();
    QCOMPARE(mkfifo(path.c_str(), 0600), 0);
    const auto port = gadget_port(path);
    std::array<std::uint8_t, 100> bytes{};
    QCOMPARE(port->receive(bytes), std::size_t{0});
    port->send(hid::Report{9});
    QCOMPARE(port->receive(bytes), std::size_t{64});
    QCOMPARE(int{bytes[0]}, 9);
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, port->unplug());
  }

  void a_gadget_is_plugged_by_its_controllers_file() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("hidg0").toStdString();
    QCOMPARE(mkfifo(path.c_str(), 0600), 0);
    QFile controller(folder.filePath("UDC"));
    const auto written = [&](const char* text) {
      return controller.open(QFile::WriteOnly) && controller.write(text) >= 0 &&
             (controller.close(), true);
    };
    const auto says = [&] {
      QByteArray text;
      if (controller.open(QFile::ReadOnly)) text = controller.readAll();
      controller.close();
      return text;
    };
    QVERIFY(written(""));
    const std::string udc = controller.fileName().toStdString();
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, gadget_port(path, udc));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, gadget_port(path, "/nowhere/UDC"));
    QVERIFY(written("dummy_udc.0\n"));
    const auto port = gadget_port(path, udc);
    QVERIFY(written(""));  // a file of settings forgets what it said before
    port->unplug();
    QCOMPARE(says(), QByteArray("\n"));
    port->send(hid::Report{9});
    std::array<std::uint8_t, 100> bytes{};
    QCOMPARE(port->receive(bytes), std::size_t{0});
    QVERIFY(written(""));
    port->plug();
    QCOMPARE(says(), QByteArray("dummy_udc.0\n"));
    port->send(hid::Report{9});
    QCOMPARE(port->receive(bytes), std::size_t{64});
  }

  void what_is_not_there_is_said_with_its_cure() {
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, gadget_port("/nowhere/hidg0"));
    try {
      uhid_port("/nowhere/uhid", {});
      QFAIL("opened");
    } catch (const std::runtime_error& error) {
      QVERIFY2(QString(error.what()).contains("sudo modprobe uhid"), error.what());
    }
  }
};

QTEST_APPLESS_MAIN(TestEmulator)
#include "tst_emulator.moc"
