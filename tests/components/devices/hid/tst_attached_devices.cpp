// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/attached_devices.hpp"

#include <QTest>
#include <cerrno>
#include <stdexcept>

#include "components/devices/hid/hidapi_link.hpp"

using namespace trocar::hid;

namespace {

const std::vector<AttachedDevice> attached{
    {.path = "/dev/hidraw0", .vendor = 0x046d, .product = 0xc077, .name = "USB Mouse"},
    {.path = "/dev/hidraw1",
     .vendor = 0x1209,
     .product = 0x0001,
     .serial = "11",
     .name = "Trocar laparoscope"},
    {.path = "/dev/hidraw2",
     .vendor = 0x1209,
     .product = 0x0001,
     .serial = "22",
     .name = "Trocar laparoscope"},
    {.path = "/dev/hidraw3", .vendor = 0x1209, .product = 0x0007, .serial = "22"}};

std::string refusal(const DeviceSelection& selection, std::span<const AttachedDevice> among) {
  try {
    return "took " + selected(selection, among).path;
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

}  // namespace

class TestAttachedDevices : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_device_is_found_by_data() {
    QTest::addColumn<QString>("serial");
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("product");
    QTest::addColumn<QString>("found");
    QTest::newRow("serial") << "22"
                            << "" << 0x0001 << "/dev/hidraw2";
    QTest::newRow("product alone") << ""
                                   << "" << 0x0007 << "/dev/hidraw3";
    QTest::newRow("path, whatever else is asked for") << "22"
                                                      << "/dev/hidraw0" << 0x0001 << "/dev/hidraw0";
  }
  void a_device_is_found_by() {
    QFETCH(QString, serial);
    QFETCH(QString, path);
    QFETCH(int, product);
    QFETCH(QString, found);
    const DeviceSelection selection{.vendor = 0x1209,
                                    .product = static_cast<std::uint16_t>(product),
                                    .serial = serial.toStdString(),
                                    .path = path.toStdString()};
    QCOMPARE(QString::fromStdString(selected(selection, attached).path), found);
  }

  void what_is_not_there_is_named_with_what_is() {
    const std::string said = refusal({.vendor = 0x1209, .product = 1, .serial = "33"}, attached);
    QCOMPARE(QString::fromStdString(said),
             QString("no HID device is 1209:0001, serial 33; the nearest is /dev/hidraw1 "
                     "1209:0001 Trocar laparoscope, serial 11; attached are:\n"
                     "  /dev/hidraw0 046d:c077 USB Mouse, no serial\n"
                     "  /dev/hidraw1 1209:0001 Trocar laparoscope, serial 11\n"
                     "  /dev/hidraw2 1209:0001 Trocar laparoscope, serial 22\n"
                     "  /dev/hidraw3 1209:0007, serial 22"));
    QCOMPARE(QString::fromStdString(refusal({.vendor = 0x1209}, {})),
             QString("no HID device is 1209:any; none at all is attached"));
    QVERIFY(refusal({.path = "/dev/hidraw7"}, attached)
                .starts_with("no HID device is at /dev/hidraw7, did you mean \"/dev/hidraw0\"?"));
    QVERIFY2(refusal({.vendor = 0xdead}, attached).find("nearest") == std::string::npos,
             "nothing is like it");
  }

  void several_that_fit_are_listed() {
    const std::string said = refusal({.vendor = 0x1209, .product = 1}, attached);
    QVERIFY(said.starts_with("2 HID devices are 1209:0001: say which by serial, or by path:"));
    QVERIFY(said.find("serial 11") != std::string::npos);
    QVERIFY(said.find("Mouse") == std::string::npos);
  }

  void numbers_of_usb() {
    QCOMPARE(usb_number("1209", "vendor"), std::uint16_t{0x1209});
    QCOMPARE(usb_number("C0fe", "vendor"), std::uint16_t{0xC0FE});
    for (const char* wrong : {"", "12", "12090", "0x12", "12g9", "-209", " 209"})
      QVERIFY_THROWS_EXCEPTION(std::invalid_argument, usb_number(wrong, "vendor"));
  }

  void a_file_that_may_not_be_opened_has_its_cure() {
    const std::string said = opening_failed(attached[1], EACCES);
    QVERIFY(said.find("KERNEL==\"hidraw*\", KERNELS==\"*:1209:0001.*\"") != std::string::npos);
    QVERIFY(said.find("Permission denied") != std::string::npos);
    QVERIFY(opening_failed(attached[1], EWOULDBLOCK).find("in use") != std::string::npos);
    QVERIFY(opening_failed(attached[1], ENOENT).find("No such file") != std::string::npos);
  }

  void this_machine_can_be_asked() {
    for (const AttachedDevice& device : attached_devices()) QVERIFY(!device.path.empty());
  }

  void a_path_without_a_device_is_refused() {
    HidapiSource source({.path = "/dev/no-such-hidraw"});
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, source.open());
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, HidapiLink("/dev/no-such-hidraw"));
  }
};

QTEST_APPLESS_MAIN(TestAttachedDevices)
#include "tst_attached_devices.moc"
