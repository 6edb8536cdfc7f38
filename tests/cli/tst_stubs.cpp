// SPDX-License-Identifier: Apache-2.0
// `trocar stubs`: what an editor learns of components, of scripts and of the language.
#include "cli/stubs.hpp"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "components/register.hpp"
#include "framework/command.hpp"
#include "framework/graph.hpp"
#include "framework/scripting/run_options.hpp"
#include "tests/cli/trocar_process.hpp"

using namespace trocar;
using namespace trocar::cli;
using namespace trocar::test;

class TestStubs : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  Registry registry_;

  static void write(const QString& name, const QByteArray& text) {
    QFile file(name);
    QVERIFY(file.open(QFile::WriteOnly) && file.write(text) == text.size());
  }
  static QByteArray read(const QString& name) {
    QFile file(name);
    return file.open(QFile::ReadOnly) ? file.readAll()
                                      : QByteArray("cannot be read: ") + name.toUtf8();
  }
  /// The lines from the one that declares a class to the next empty one.
  static std::string class_text(const std::string& text, const std::string& name) {
    const std::size_t begin = text.find("---@class " + name + "\n");
    return begin == std::string::npos ? "" : text.substr(begin, text.find("\n\n", begin) - begin);
  }
  /// The line above a field: what is shown of it.
  static std::string shown(const std::string& text, const std::string& field) {
    std::size_t at = text.find("---@field " + field + " ");
    if (at == std::string::npos) at = text.find("---@field " + field + "? ");
    if (at == std::string::npos) return "no field " + field;
    const std::size_t begin = text.rfind('\n', at - 2);
    return text.substr(begin + 1, at - begin - 2);
  }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

 private Q_SLOTS:
  void initTestCase() {
    register_components(registry_);
    QVERIFY(QDir::setCurrent(folder_.path()));
    write("wall.lua",
          "local laparoscope = trocar.Laparoscope { hand = 'push' }\n"
          "local wall = trocar.Wall { at = laparoscope.tip }\n"
          "trocar.run { duration = '1 s' }\n"
          "error('beyond the first run')\n");
    write("broken.lua", "\ntrocar.Wal {}\n");
  }
  void init() { QDir(folder_.filePath(".trocar")).removeRecursively(); }

  void every_port_and_parameter_is_there_with_its_unit() {
    const std::string text = components_stub(registry_);
    for (const ComponentType& type : registry_.types()) {
      const Description description = describe(registry_, type.name);
      const std::string settings = class_text(text, "trocar." + type.name + ".Settings");
      const std::string instance = class_text(text, "trocar." + type.name);
      QVERIFY2(has(text, "function trocar." + type.name + "(settings) end"), type.name.c_str());
      for (const Description::Port& input : description.inputs)
        QVERIFY2(has(shown(settings, input.name), input.unit), input.name.c_str());
      for (const Description::Port& output : description.outputs) {
        const std::size_t dot = output.name.find('.');
        const std::string owner =
            dot == std::string::npos
                ? instance
                : class_text(text, "trocar." + type.name + "." + output.name.substr(0, dot));
        const std::string name = output.name.substr(dot == std::string::npos ? 0 : dot + 1);
        QVERIFY2(has(shown(owner, name), output.unit), output.name.c_str());
        QVERIFY2(has(shown(owner, name), output.doc), output.name.c_str());
        QVERIFY2(has(owner + "\n", name + " trocar.Output." + output.type + "\n"),
                 output.name.c_str());
      }
      for (const Description::Parameter& parameter : description.parameters) {
        const std::string doc = shown(settings, parameter.name);
        QVERIFY2(has(doc, parameter.range.empty() ? parameter.unit : parameter.range), doc.c_str());
        QVERIFY2(has(doc, parameter.initial) && has(doc, parameter.doc), doc.c_str());
      }
    }
  }

  void a_required_parameter_is_not_optional() {
    const std::string text = components_stub(registry_);
    QVERIFY(has(class_text(text, "trocar.Wall.Settings"), "---@field stiffness? trocar.Quantity|"));
    QVERIFY(has(class_text(text, "trocar.Delay.Settings"), "---@field initial any\n"));
  }

  void what_a_definition_declares_may_be_read() {
    const std::string text = components_stub(registry_);
    QVERIFY(has(class_text(text, "trocar.GenericHid.Settings"), "---@field layout any\n"));
    const std::string instance = class_text(text, "trocar.GenericHid");
    QVERIFY(has(instance + "\n", "---@field [string] trocar.Output.any\n"));
    QVERIFY(has(instance, "---@field status trocar.Output.Enumeration\n"));
    QVERIFY(!has(instance, "---@field layout"));
  }

  void a_group_has_sites_parts_and_dotted_keys() {
    const std::string text = components_stub(registry_);
    const std::string instance = class_text(text, "trocar.Laparoscope");
    QVERIFY(has(instance, "---@field tip trocar.Site\n"));
    QVERIFY(has(instance, "---@field tool trocar.LaparoscopeKinematics\n"));
    QVERIFY(has(class_text(text, "trocar.Laparoscope.Settings"),
                "---@field [\"device.push_distance\"]? trocar.Quantity"));
    QVERIFY(has(class_text(text, "trocar.Thread"),
                "---@field Wall fun(settings: trocar.Wall.Settings): trocar.Wall\n"));
  }

  void all_that_trocar_run_takes_is_there() {
    const std::string options = class_text(std::string(language_stub()), "trocar.RunOptions");
    for (const std::string& name : lua::run_option_names())
      QVERIFY2(has(options, "---@field " + name + "? "), name.c_str());
    for (const std::string& request : request_names())
      QVERIFY2(has(options, "\"" + request + "\""), request.c_str());
  }

  void the_files_are_lua_and_say_what_was_done() {
    const Ran ran = run_trocar({"stubs", "wall.lua"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.status, 0);
    const QStringList files = QDir(".trocar").entryList(QDir::Files);
    QCOMPARE(files,
             (QStringList{"components.lua", "laws.lua", "names.lua", "specs.lua", "trocar.lua"}));
    for (const QString& file : files) {
      QVERIFY(ran.out.contains((".trocar/" + file + ": written\n").toUtf8()));
      const Ran read = run_trocar({"check", ".trocar/" + file});
      QVERIFY2(read.status == 0, read.out + read.err);
    }
    QVERIFY(run_trocar({"stubs"}).out.contains(".trocar/trocar.lua: written anew\n"));
  }

  void names_of_a_script_complete() {
    QCOMPARE(run_trocar({"stubs", "wall.lua"}).status, 0);
    const std::string names = read(".trocar/names.lua").toStdString();
    QVERIFY(has(names, "---| '\"wall.force.z\"' # [N]\n"));
    QVERIFY(has(class_text(names, "trocar.Run"), "---@field [\"wall.force\"] trocar.Signal\n"));
    QVERIFY(has(class_text(names, "trocar.Set"), "---@field [\"laparoscope.ideal\"] any?\n"));
    QVERIFY(has(class_text(names, "trocar.Edit"), "---@field [\"wall.stiffness\"] any?\n"));
    QVERIFY(!has(class_text(names, "trocar.Edit"), "laparoscope.ideal"));
  }

  void a_broken_script_is_reported_and_nothing_written() {
    const Ran ran = run_trocar({"stubs", "broken.lua"});
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.contains("broken.lua:2: there is no trocar.Wal"), ran.err);
    QVERIFY(!QDir(".trocar").exists());
  }

  void what_a_user_wrote_is_kept() {
    write(".luarc.json", "{}\n");
    QFile::remove(".luacheckrc");
    const Ran ran = run_trocar({"stubs"});
    QVERIFY(ran.out.contains(".luarc.json: there already, and kept: its \"workspace.library\""));
    QCOMPARE(read(".luarc.json"), QByteArray("{}\n"));
    QVERIFY(ran.out.contains(".luacheckrc: written\n"));
    write(".trocar/specs.lua", "-- mine\n");
    const Ran again = run_trocar({"stubs"});
    QCOMPARE(again.status, 1);
    QVERIFY2(again.err.contains("specs.lua is there and not of trocar stubs"), again.err);
    QCOMPARE(read(".trocar/specs.lua"), QByteArray("-- mine\n"));
  }

  void another_folder_is_what_the_settings_name() {
    QFile::remove(".luarc.json");
    QFile::remove(".luacheckrc");
    QCOMPARE(run_trocar({"stubs", "--out", "editor/lua"}).status, 0);
    QVERIFY(QFile::exists("editor/lua/trocar.lua"));
    QVERIFY(read(".luarc.json").contains("\"editor/lua\""));
    QVERIFY(read(".luacheckrc").contains("exclude_files = { \"editor/lua/**\" }"));
  }
};

QTEST_GUILESS_MAIN(TestStubs)
#include "tst_stubs.moc"
