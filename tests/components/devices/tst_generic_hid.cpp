// SPDX-License-Identifier: Apache-2.0
// GenericHid: outputs by a layout, played reports, and a device that comes and goes.
#include "components/devices/generic_hid.hpp"

#include "tests/support/input_device.hpp"
#include "tests/support/script_bench.hpp"

// Behind Qt's macros in a name of the framework's.
#include <QTest>

#include "tests/support/allocation_counter.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

constexpr int absent = 0, quiet = 1, sending = 2;

const char* const layout =
    "return { vendor = '046d', product = 'c626', bytes = 4, fields = {\n"
    "  push = { report = 1, bits = 8, signed = true, scale = 0.01, unit = 'm/s',\n"
    "    x = { offset = 8 }, y = { offset = 16 }, z = { offset = 24 } },\n"
    "  button = { report = 2, offset = 8, bits = 1, held = 'attached' },\n"
    "  lever = { report = 2, offset = 16, bits = 8, unit = 'mm', held = 'always', rest = 5 },\n"
    "  hat = { report = 3, offset = 8, bits = 4, rest = 8 } } }\n";

/// The component on a port into which the test plugs a device.
struct Bench {
  PortHid hid{std::make_shared<hid::DeviceLayout>(read_layout_text(layout).layout.value())};

  void begin(const char* play = nullptr, bool virtual_time = false) {
    hid.set_name("mouse");
    if (play != nullptr) {
      Findings wrong;
      hid.play.set(*lua::read_definition("play.lua", "play.lua", play, wrong));
    }
    hid.configure({.period = 1e-3, .virtual_time = virtual_time});
    hid.start();
  }
  void at(std::int64_t ms) { hid.step({.time_ns = ms * 1'000'000}); }
  double number(const char* name) const {
    return *reinterpret_cast<const double*>(hid.find_output(name)->data());
  }
  Vector3 push() const {
    return *reinterpret_cast<const Vector3*>(hid.find_output("push")->data());
  }
  bool button() const { return *reinterpret_cast<const bool*>(hid.find_output("button")->data()); }
  std::int64_t status() const { return hid.status->index; }
};

const QByteArray mouse =
    "local mouse = trocar.GenericHid { layout = \"space_navigator\",\n"
    "  play = { { at = \"2 ms\", bytes = \"01 5e 01 00 00 a2 fe\" },\n"
    "    { at = \"4 ms\", bytes = { 3, 1, 0 } }, { at = \"6 ms\", plug = \"out\" } } }\n";

}  // namespace

class TestGenericHid : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void fields_are_outputs_with_units() {
    Bench bench;
    const auto text = [&](const char* name) {
      return bench.hid.find_output(name)->signature()->text();
    };
    QCOMPARE(text("push"), std::string("Vector3 [m/s]"));
    QCOMPARE(text("lever"), std::string("double [mm]"));
    QCOMPARE(text("button"), std::string("bool [1]"));
    QCOMPARE(text("hat"), std::string("double [1]"));
  }

  void played_reports_come_at_their_times() {
    Bench bench;
    bench.begin(
        "return { { at = '5 ms', bytes = '02 01 14' }, { at = '2 ms', bytes = { 1, 100, 0, 156 } } "
        "}",
        true);
    QCOMPARE(bench.status(), quiet);
    QCOMPARE(bench.number("hat"), 8.0);
    QCOMPARE(bench.number("lever"), 5e-3);
    bench.at(1);
    QCOMPARE(bench.push().x, 0.0);
    bench.at(2);
    QCOMPARE(bench.push().x, 1.0);
    QCOMPARE(bench.push().z, -1.0);
    QCOMPARE(bench.status(), sending);
    QVERIFY(!bench.button());
    bench.at(5);
    QVERIFY(bench.button());
    QCOMPARE(bench.number("lever"), 20e-3);
    QCOMPARE(*bench.hid.reports, 2);
    QVERIFY(bench.hid.device == nullptr);  // no device was looked for
  }

  void velocities_are_zero_once_reports_stop() {
    Bench bench;
    bench.begin(
        "return { { at = 0, bytes = '01 64 00 00' }, { at = 0, bytes = '02 01 14' },\n"
        "  { at = '50 ms', bytes = '03 02' } }",
        true);
    bench.at(100);
    QCOMPARE(bench.push().x, 1.0);
    QCOMPARE(bench.number("hat"), 2.0);
    bench.at(101);  // beyond 100 ms: the other report does not count for it
    QCOMPARE(bench.push().x, 0.0);
    QCOMPARE(bench.number("hat"), 2.0);
    QCOMPARE(bench.status(), sending);
    bench.at(151);
    QCOMPARE(bench.number("hat"), 8.0);
    QCOMPARE(bench.status(), quiet);
    QVERIFY(bench.button());  // it is sent on a change
    QCOMPARE(bench.number("lever"), 20e-3);
  }

  void unplugged_everything_is_at_rest_but_positions() {
    Bench bench;
    bench.begin(
        "return { { at = 0, bytes = '01 64 00 00' }, { at = 0, bytes = '02 01 14' },\n"
        "  { at = '10 ms', plug = 'out' }, { at = '11 ms', bytes = '01 64 00 00' },\n"
        "  { at = '20 ms', plug = 'in' }, { at = '21 ms', bytes = '01 32 00 00' } }",
        true);
    bench.at(9);
    QVERIFY(bench.button());
    bench.at(10);
    QCOMPARE(bench.status(), absent);
    QCOMPARE(bench.push().x, 0.0);
    QVERIFY(!bench.button());
    QCOMPARE(bench.number("lever"), 20e-3);
    bench.at(12);
    QCOMPARE(bench.push().x, 0.0);
    bench.at(20);
    QCOMPARE(bench.status(), quiet);
    QVERIFY(!bench.button());
    QCOMPARE(*bench.hid.connections, 2);
    bench.at(21);
    QCOMPARE(bench.push().x, 0.5);
  }

  void what_is_no_report_is_counted_and_changes_nothing() {
    Bench bench;
    bench.begin(
        "return { { at = 0, bytes = '01 64 00 00' }, { at = 0, bytes = '01 0a 0a' },\n"
        "  { at = 0, bytes = '17 64 00' }, { at = 0, bytes = '01 32 00 00 ff ff' } }",
        true);
    bench.at(0);
    QCOMPARE(bench.push().x, 0.5);  // of one that is longer than its fields
    QCOMPARE(*bench.hid.reports, 2);
    QCOMPARE(*bench.hid.reports_ignored, 2);
  }

  void in_virtual_time_no_device_is_opened() {
    Bench bench;
    bench.begin(nullptr, true);
    bench.at(1);
    QCOMPARE(bench.status(), absent);
    QVERIFY(bench.hid.device == nullptr);
  }

  void a_device_is_read() {
    Bench bench;
    bench.begin();
    QCOMPARE(bench.status(), quiet);
    bench.hid.send({1, 100, 0, 0});
    bench.hid.send({2, 1, 20});
    bench.hid.tick();
    QCOMPARE(bench.push().x, 1.0);
    QVERIFY(bench.button());
    QCOMPARE(bench.status(), sending);
    bench.hid.tick(99);
    QCOMPARE(bench.push().x, 1.0);
    bench.hid.tick(3);
    QCOMPARE(bench.push().x, 0.0);
    QCOMPARE(bench.status(), quiet);
    bench.hid.stop();
  }

  void a_device_that_is_unplugged_may_come_back() {
    Bench bench;
    bench.begin();
    bench.hid.send({1, 100, 0, 0});
    bench.hid.tick();
    QCOMPARE(bench.push().x, 1.0);
    bench.hid.device.reset();
    bench.hid.present = false;
    bench.hid.tick();
    QCOMPARE(bench.status(), absent);
    QCOMPARE(bench.push().x, 0.0);
    QVERIFY(bench.hid.failure() == nullptr);
    bench.hid.tick(5000);
    QCOMPARE(bench.status(), absent);
    bench.hid.present = true;
    bench.hid.tick(1001);
    QCOMPARE(bench.status(), quiet);
    bench.hid.send({1, 50, 0, 0});
    bench.hid.tick();
    QCOMPARE(bench.push().x, 0.5);
    QCOMPARE(*bench.hid.connections, 2);
  }

  void a_device_may_come_later() {
    Bench bench;
    bench.hid.present = false;
    bench.begin();
    QCOMPARE(bench.status(), absent);
    bench.hid.present = true;
    bench.hid.tick();  // it is looked for each second
    QCOMPARE(bench.status(), absent);
    bench.hid.tick(1000);
    QCOMPARE(bench.status(), quiet);
  }

  void one_that_is_needed_must_be_there() {
    Bench bench;
    bench.hid.present = false;
    bench.hid.needed.set({true});
    try {
      bench.begin();
      QFAIL("it began");
    } catch (const std::runtime_error& error) {
      QCOMPARE(QByteArray(error.what()), QByteArray("mouse: no HID device is 046d:c626"));
    }
  }

  void its_thread_reads_until_the_device_is_gone() {
    const auto read = read_layout_text(layout);
    std::unique_ptr<hid::PipeLink> device;
    bool present = true;
    MonotonicTime time;
    hid::InputLine line(std::make_unique<TestPort>(device, present), time, *read.layout);
    line.open();
    present = false;
    line.start("mouse");
    hid::InputSnapshot snapshot;
    const auto comes = [&](const auto& what) {
      const std::int64_t end = time.now() + 10'000'000'000;
      while (!what() && time.now() < end) line.load(snapshot);
      return what();
    };
    device->write(std::vector<std::uint8_t>{1, 100, 0, 0});
    QVERIFY(comes([&] { return snapshot.reports == 1; }));
    QCOMPARE(snapshot.value[read.layout->fields.fields().size() - 3], 1.0);  // push.x
    device.reset();
    QVERIFY(comes([&] { return !snapshot.attached; }));
  }

  void steps_allocate_nothing() {
    Bench played;
    std::string play = "return {";
    for (int i = 0; i < 400; ++i)
      play += "{ at = '" + std::to_string(i) + " ms', bytes = '01 64 00 00' },";
    played.begin((play + "}").c_str(), true);
    QCOMPARE(allocations_in([&] {
               for (int i = 0; i < 1000; ++i) played.at(i);
             }),
             0);
    QCOMPARE(*played.hid.reports, 400);
    Bench read;
    read.begin();
    for (int i = 0; i < 20; ++i) read.hid.send({1, 100, 0, 0});
    QCOMPARE(allocations_in([&] {
               for (int i = 0; i < 1000; ++i) read.hid.tick(0.01);
             }),
             0);
    QCOMPARE(*read.hid.reports, 20);
  }

  void a_script_uses_its_outputs() {
    const ScriptOutcome outcome = run_script_text(
        mouse +
        "local speed = \"2 m/s\" * mouse.translation.x\n"
        "local run = trocar.run { duration = \"10 ms\" }\n"
        "assert(run:at(mouse.translation.x, \"3 ms\") == 1)\n"
        "assert(run:at(mouse.translation.z, \"3 ms\") == -1)\n"
        "assert(run:at(speed, \"3 ms\") == 2)\n"
        "assert(run:at(mouse.left, \"3 ms\") == 0 and run:at(mouse.left, \"5 ms\") == 1)\n"
        "assert(run:at(mouse.left, \"7 ms\") == 0)\n"
        "assert(run:at(\"generic_hid.status\", \"7 ms\") == 0 and #run.faults == 0)\n");
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
  }

  void two_devices_have_ports_of_their_own() {
    const ScriptOutcome outcome = run_script_text(
        "local mouse = trocar.GenericHid { layout = \"space_navigator\" }\n"
        "local pad = trocar.GenericHid { name = \"pad\", layout = \"dualshock4\" }\n"
        "trocar.Scale { input = mouse.translation.x, factor = 2 }\n"
        "trocar.Scale { name = \"two\", input = pad.left_x, factor = 2 }\n");
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
  }

  void what_is_wrong_in_a_script_is_named_data() {
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<QStringList>("findings");
    const auto row = [](const char* name, const QByteArray& settings, const QStringList& findings) {
      QTest::newRow(name) << QByteArray("\nlocal hid = trocar.GenericHid {" + settings + "}\n")
                          << findings;
    };
    const QByteArray named = "layout = \"space_navigator\", ";
    row("no layout", "", {"2: GenericHid needs its layout, e.g. trocar.GenericHid { layout = \""});
    row("a number", "layout = 7", {"2: layout = 7: needs a table or the name of a file, e.g."});
    row("a name", "layout = \"space_navigater\"",
        {"2: layout = \"space_navigater\": there is neither a shipped layout of that name nor "
         "space_navigater.lua beside the script, did you mean \"space_navigator\"?"});
    row("a file", "layout = \"my.lua\"", {"2: layout = \"my.lua\": there is no file "});
    row("a table",
        "layout = { vendor = \"046d\", product = \"c626\", fields = {\n"
        "  a = { offset = 8, bits = 8, unit = \"mn\" }, b = { offset = 8, bits = 33 } } }",
        {"2: fields.a.unit: ", "2: fields.b: bits = 33: a field has 1 to 32"});
    row("a name of its own",
        "layout = { vendor = \"046d\", product = \"c626\",\n"
        "  fields = { status = { offset = 8, bits = 8 } } }",
        {"2: fields.status: is the name of something that each GenericHid has: take another"});
    row("a parameter", named + "stael = \"1 s\"",
        {"2: generic_hid (a GenericHid) has no input or "
         "parameter \"stael\", did you mean \"stale\"?"});
    row("an entry", named + "lay_out = \"x\"",
        {"2: generic_hid (a GenericHid) has no input or "
         "parameter \"lay_out\", did you mean \"layout\"?"});
    row("to play nothing", named + "play = 7",
        {"2: generic_hid: play = 7: needs a list, e.g. { { at = \"0 s\", bytes = "});
    const auto played = [&](const char* name, const QByteArray& entry, const QString& says) {
      row(name, named + "play = { { at = 0, plug = \"out\" }, " + entry + " }",
          {"2: generic_hid: play, entry 2: " + says});
    };
    played("no time", "{ bytes = \"01\" }", "needs its time, at = \"20 ms\"");
    played("a time", "{ at = \"1 m\", bytes = \"01\" }", "at = \"1 m\": needs s, from 0 to 1e6");
    played("a negative time", "{ at = \"-1 s\", bytes = \"01\" }", "at = \"-1 s\": needs s, from");
    played("no bytes", "{ at = \"1 s\" }", "needs bytes or plug, one of them");
    played("half a byte", "{ at = \"1 s\", bytes = \"01 2\" }", "bytes = \"01 2\": needs two hexa");
    played("no byte", "{ at = \"1 s\", bytes = { 256 } }", "bytes = {256}: needs whole numbers");
    played("empty", "{ at = \"1 s\", bytes = {} }", "bytes = {}: needs 1 to 1024 bytes");
    played("a plug", "{ at = \"1 s\", plug = \"off\" }", "plug = \"off\": needs \"out\" or \"in\"");
    played("an entry", "{ at = \"1 s\", byts = \"01\" }",
           "there is no \"byts\", did you mean \"bytes\"?");
    played("a text", "\"01\"", "\"01\": needs a table, e.g. { at = ");
  }
  void what_is_wrong_in_a_script_is_named() {
    QFETCH(QByteArray, script);
    QFETCH(QStringList, findings);
    const ScriptOutcome outcome = run_script_text(script);
    QVERIFY2(match(outcome.findings, findings), qPrintable(outcome.findings.join('\n')));
  }

  void an_unknown_output_is_named() {
    const ScriptOutcome outcome =
        run_script_text(mouse + "trocar.Scale { input = mouse.translatoin.x, factor = 2 }\n");
    QCOMPARE(outcome.findings.size(), 1);
    QVERIFY2(outcome.findings[0].contains("did you mean \"translation\"?"),
             qPrintable(outcome.findings[0]));
  }

  void a_file_beside_the_script_is_read_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    QTest::newRow("right") << QByteArray(layout) << "";
    QTest::newRow("a field") << QByteArray(layout).replace("bits = 4", "bits = 44")
                             << "6: fields.hat: bits = 44: a field has 1 to 32";
    QTest::newRow("a part")
        << QByteArray(layout).replace("offset = 24", "offset = 20")
        << "3: fields.push.z: bits 20 to 27 of report 1 overlap with \"push.y\"";
    QTest::newRow("no end") << QByteArray("while true do end")
                            << "took more than 1000000 instructions";
    QTest::newRow("of Lua's") << QByteArray("\nreturn { fields == 1 }") << "2: there is no";
  }
  void a_file_beside_the_script_is_read() {
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const QTemporaryDir folder;
    const auto write = [&](const char* name, const QByteArray& content) {
      QFile file(folder.filePath(name));
      return file.open(QFile::WriteOnly) && file.write(content) == content.size();
    };
    QVERIFY(write("mine.lua", text));
    QVERIFY(write("script.lua",
                  "for _, name in ipairs { 'mine', 'mine.lua' } do\n"
                  "  local hid = trocar.GenericHid { name = 'hid' .. #name, layout = name }\n"
                  "  trocar.Scale { name = 's' .. #name, input = hid.push.x, factor = 2 }\n"
                  "end\n"));
    SessionOptions options;
    options.check_only = true;
    const ScriptOutcome outcome = run_script_file(folder.filePath("script.lua"), {}, options);
    if (says.isEmpty())
      QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    else
      QVERIFY2(outcome.findings.value(0).contains(says), qPrintable(outcome.findings.join('\n')));
  }
};

QTEST_GUILESS_MAIN(TestGenericHid)
#include "tst_generic_hid.moc"
