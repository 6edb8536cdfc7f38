// SPDX-License-Identifier: Apache-2.0
// What a layout in Lua says of a device, and what is wrong with one.
#include <QFile>
#include <QTest>

#include "tests/support/input_device.hpp"

using namespace trocar;
using namespace trocar::hid;
using namespace trocar::test;

namespace {

std::string device_with(const std::string& fields) {
  return "return { vendor = '046d', product = 'c626', bytes = 7, fields = {\n" + fields + "\n} }\n";
}

}  // namespace

class TestDeviceLayout : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void kinds_follow_from_what_a_field_has() {
    const ReadLayout read = read_layout_text(device_with(
        "button = { report = 3, offset = 8, bits = 1 },\n"
        "lever = { report = 1, offset = 8, bits = 16, unit = 'mm', scale = 0.5, centre = 100 },\n"
        "push = { report = 2, bits = 8, signed = true, unit = 'm/s', frame = 'device',\n"
        "  held = 'always', x = { offset = 8 }, y = { offset = 16, scale = -1 },\n"
        "  z = { offset = 24, rest = 10 } }"));
    QVERIFY2(read.wrong.empty(), read.wrong.empty() ? "" : read.wrong[0].c_str());
    const std::vector<LayoutOutput>& outputs = read.layout->outputs;
    QCOMPARE(outputs.size(), std::size_t(3));
    QVERIFY(outputs[0].kind == LayoutOutput::Kind::flag);
    QVERIFY(outputs[1].kind == LayoutOutput::Kind::number);
    QCOMPARE(outputs[1].unit, std::string("mm"));
    QVERIFY(outputs[2].kind == LayoutOutput::Kind::vector && outputs[2].held == Held::always);
    QCOMPARE(outputs[2].frame, std::string("device"));
    QCOMPARE(outputs[2].first, std::size_t(2));
    QCOMPARE(outputs[2].rest[2], 10.0);

    double values[5] = {};
    const std::uint8_t lever[] = {1, 102, 0}, push[] = {2, 0xFF, 3, 4};
    QVERIFY(read.layout->fields.decode(lever, values));
    QVERIFY(read.layout->fields.decode(push, values));
    QCOMPARE(values[1], 1e-3);  // in SI
    QCOMPARE(values[2], -1.0);
    QCOMPARE(values[3], -3.0);
    QCOMPARE(values[4], 4.0);
  }

  void the_documents_example_is_one() {
    QFile page(TROCAR_SOURCE_DIR "/docs/devices.md");
    QVERIFY(page.open(QFile::ReadOnly));
    const QByteArray text = page.readAll();
    const qsizetype begin = text.indexOf("-- pedal.lua");
    QVERIFY(begin > 0);
    const ReadLayout read =
        read_layout_text(text.mid(begin, text.indexOf("```", begin) - begin).toStdString());
    QVERIFY2(read.wrong.empty(), read.wrong.empty() ? "" : read.wrong[0].c_str());
    QCOMPARE(read.layout->outputs.size(), std::size_t(3));
  }

  void a_device_may_have_several_products() {
    const ReadLayout read = read_layout_text(
        "return { vendor = '054c', product = { '05c4', '09cc' },\n"
        "  fields = { a = { offset = 0, bits = 8 } } }");
    QVERIFY(read.layout.has_value());
    QCOMPARE(read.layout->device.text(), std::string("054c:05c4 or 09cc"));
    QVERIFY(read.layout->device.fits({.vendor = 0x054c, .product = 0x09cc}));
    QVERIFY(read.layout->device.fits({.vendor = 0x054c, .product = 0x05c4}));
    QVERIFY(!read.layout->device.fits({.vendor = 0x054c, .product = 0x09cd}));
  }

  void what_is_wrong_is_named_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("says");
    const auto layout = [](const char* name, const char* text, const char* says) {
      QTest::newRow(name) << text << says;
    };
    const auto field = [](const char* name, const char* fields, const char* says) {
      QTest::newRow(name) << QString::fromStdString(device_with(fields)) << says;
    };
    layout("nothing", "local x = 1", "layout.lua:1: returns nothing: let it end with return { … }");
    layout("a number", "return 7", "layout.lua:1: returns a number");
    layout("a list", "return { 1, 2 }", ": {1, 2}: needs a table whose entries have names");
    layout("a mistake of Lua's", "\nlocal x = nil + 1\nreturn {}", "layout.lua:2: attempt");
    layout(
        "no end", "local n = 0\nwhile true do n = n + 1 end",
        "layout.lua:2: took more than 1000000 instructions: it has to return a table, and to end");
    layout("a file", "return io.open('x')", "layout.lua:1: ");
    layout("itself", "local t = {}\nfor i = 1, 9 do t[i] = t end\nreturn t",
           "layout.lua:1: returns a table that is too large, or holds itself");
    layout("an entry", "return { vendor = '046d', product = 'c626', feilds = {} }",
           "feilds: there is no such entry, did you mean \"fields\"?");
    layout("no vendor", "return { product = 'c626', fields = { a = { offset = 0, bits = 8 } } }",
           "vendor: is missing, e.g. vendor = \"046d\"");
    layout("a vendor", "return { vendor = 46, product = 'c626' }", "vendor: 46: needs a text");
    layout("a product", "return { vendor = '046d', product = '0xc626' }",
           "product: \"0xc626\": four hexadecimal digits are needed");
    layout("bytes", "return { vendor = '046d', product = 'c626', bytes = 1025 }",
           "bytes: 1025: a report has 1 to 1024");
    field("no fields", "", "fields: none: needs some, e.g. fields = { left = ");
    field("a number", "a = 7", "fields.a: 7: needs a table whose entries have names");
    field("an entry", "a = { offset = 0, bits = 8, singed = true }",
          "fields.a.singed: there is no such entry, did you mean \"signed\"?");
    field("a name", "['a b'] = { offset = 0, bits = 8 }", "fields.a b: is no name of an output");
    field("no offset", "a = { bits = 8 }", "fields.a: needs offset, the bit where it begins");
    field("no bits", "a = { offset = 8 }", "fields.a: needs bits, how many it has");
    field("half a bit", "a = { offset = 0.5, bits = 8 }", "fields.a.offset: 0.5: needs a whole");
    field("too many bits", "a = { offset = 0, bits = 33 }",
          "fields.a: bits = 33: a field has 1 to 32");
    field("no bit", "a = { offset = 0, bits = 0 }", "fields.a: bits = 0: a field has 1 to 32");
    field("beyond the report", "a = { report = 1, offset = 48, bits = 16 }",
          "fields.a: offset = 48: 16 bits from there end in byte 8 of a report of 7");
    field("in the number", "a = { report = 1, offset = 4, bits = 8 }",
          "fields.a: offset = 4: from 8, since the first 8 bits are the report's number");
    field("a report", "a = { report = 256, offset = 8, bits = 8 }",
          "fields.a: report = 256: numbers are 1 to 255, and 0 for a device without");
    field("an overlap",
          "a = { report = 1, offset = 8, bits = 8 }, b = { report = 1, offset = 12, bits = 4 }",
          "fields.b: bits 12 to 15 of report 1 overlap with \"a\", 8 to 15");
    field(
        "an overlap in a vector",
        "a = { report = 1, bits = 16, x = { offset = 8 }, y = { offset = 24 }, z = { offset = 32 } "
        "}",
        "fields.a.z: bits 32 to 47 of report 1 overlap with \"a.y\", 24 to 39");
    field("numbered or not",
          "a = { offset = 8, bits = 8 }, b = { report = 1, offset = 8, bits = 8 }",
          "fields.b: report = 1: \"a\" has 0; a device numbers all its reports, or none");
    field("a unit", "a = { offset = 8, bits = 8, unit = 'mn' }", "fields.a.unit: ");
    field("two units", "a = { offset = 8, bits = 8, unit = 'm, m' }", "fields.a.unit: ");
    field("no scale", "a = { offset = 8, bits = 8, scale = 0 }",
          "fields.a: scale = 0: must be finite, and not zero");
    field("a scale that is none", "a = { offset = 8, bits = 8, scale = 1 / 0 }",
          "fields.a: scale = inf: must be finite");
    field("a centre", "a = { offset = 8, bits = 8, centre = 0 / 0 }", "fields.a: centre = ");
    field("a rest", "a = { offset = 8, bits = 8, rest = 1 / 0 }", "fields.a.rest: inf: must be");
    field("signed", "a = { offset = 8, bits = 8, signed = 1 }",
          "fields.a.signed: 1: needs true or false");
    field("held", "a = { offset = 8, bits = 8, held = 'alwys' }",
          "fields.a.held: \"alwys\" is none of never, attached, always, did you mean \"always\"?");
    field("a function", "a = { offset = print, bits = 8 }", "layout.lua:2: ");
    field("half a vector", "a = { bits = 8, x = { offset = 8 }, y = { offset = 16 } }",
          "fields.a.z: is missing: a vector has x, y and z");
    field("a unit of a part",
          "a = { bits = 8, x = { offset = 8, unit = 'm' }, y = { offset = 16 }, z = { offset = 24 "
          "} }",
          "fields.a.x.unit: there is no such entry");
    field("a frame of a number", "a = { offset = 8, bits = 8, frame = 'device' }",
          "fields.a.frame: is for vectors");
  }
  void what_is_wrong_is_named() {
    QFETCH(QString, text);
    QFETCH(QString, says);
    const ReadLayout read = read_layout_text(text.toStdString());
    QVERIFY(!read.layout.has_value());
    QVERIFY(!read.wrong.empty());
    QVERIFY2(QString::fromStdString(read.wrong[0]).startsWith(says), read.wrong[0].c_str());
  }

  void all_mistakes_are_told_at_once() {
    const ReadLayout read = read_layout_text(
        "return { product = 'c626', fields = { a = { offset = 0, bits = 40, held = 'no' },\n"
        "  b = { offset = 8 } } }");
    QCOMPARE(read.wrong.size(), std::size_t(4));
  }

  void more_numbers_than_there_is_room_for_are_refused() {
    const auto with = [](int count) {
      return read_layout_text(
          "local fields = {}\nfor i = 1, " + std::to_string(count) +
          " do fields['f' .. i] = { offset = 8 * i, bits = 8 } end\n"
          "return { vendor = '046d', product = 'c626', bytes = 100, fields = fields }");
    };
    QVERIFY(with(64).layout.has_value());
    QCOMPARE(with(65).wrong,
             std::vector<std::string>{"fields: 65 numbers: there may be 64, and 3 are a vector's"});
  }
};

QTEST_APPLESS_MAIN(TestDeviceLayout)
#include "tst_device_layout.moc"
