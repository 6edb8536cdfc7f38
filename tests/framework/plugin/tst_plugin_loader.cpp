// SPDX-License-Identifier: Apache-2.0
// What the loader takes, what it refuses, and that each refusal says what to do. The plugins are in
// tests/plugins; those of another build are good.so with other bytes in its PluginBuild.
#include "framework/plugin/plugin_loader.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cstddef>
#include <cstdlib>

#include "framework/plugin/plugin_file.hpp"

using namespace trocar;

namespace {

QByteArray bytes_of(const QString& file) {
  QFile input(file);
  return input.open(QFile::ReadOnly) ? input.readAll() : QByteArray();
}

QString test_plugin(const QString& name) {
  return QString(TROCAR_TEST_PLUGINS "/%1.so").arg(name);
}

/// A folder to search, with a registry of its own.
struct Shelf {
  QTemporaryDir folder;
  Registry registry;

  QString path(const QString& name) const { return folder.filePath(name); }
  void write(const QString& name, const QByteArray& bytes) const {
    QFile file(path(name));
    if (!file.open(QFile::WriteOnly) || file.write(bytes) != bytes.size())
      qFatal("%s cannot be written", qPrintable(file.fileName()));
  }
  void put(const QString& name) const { write(name + ".so", bytes_of(test_plugin(name))); }
  PluginFolder searched() const { return {folder.path().toStdString()}; }
  Plugins load() { return load_plugins(registry, {searched()}); }
};

/// The only reason of the only refusal.
QString only_reason(const Plugins& plugins) {
  if (!plugins.loaded.empty()) return "it was loaded";
  if (plugins.refused.size() != 1) return "not one was refused";
  if (plugins.refused.front().reasons.size() != 1) return "there is not one reason";
  return QString::fromStdString(plugins.refused.front().reasons.front());
}

/// good.so as if it had been built otherwise.
QByteArray rebuilt(std::size_t offset, std::int32_t value) {
  QByteArray bytes = bytes_of(test_plugin("good"));
  const PluginBuild& own = framework_build();
  const auto at = bytes.indexOf(QByteArray(own.mark.data(), qsizetype(own.mark.size())));
  if (at < 0) qFatal("good.so has no PluginBuild");
  return bytes.replace(at + qsizetype(offset), qsizetype(sizeof value),
                       QByteArray(reinterpret_cast<const char*>(&value), sizeof value));
}

}  // namespace

class TestPluginLoader : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { unsetenv("TROCAR_TEST_PLUGIN_RAN"); }

  void a_sound_one_is_in_the_registry() {
    Shelf shelf;
    shelf.put("good");
    const Plugins plugins = shelf.load();
    QVERIFY(plugins.refused.empty());
    QCOMPARE(plugins.loaded.size(), std::size_t(1));
    const LoadedPlugin& good = plugins.loaded.front();
    QCOMPARE(good.name, std::string("good"));
    QCOMPARE(good.version, std::string("2.1"));
    QCOMPARE(good.licence, std::string("MIT"));
    QCOMPARE(good.doc, std::string("A nudge and a beacon"));
    QCOMPARE(QString::fromStdString(good.file.string()), shelf.path("good.so"));
    QCOMPARE(good.components, std::vector<std::string>{"Nudge"});
    QCOMPARE(good.services, std::vector<std::string>{"beacon"});
    QVERIFY(std::getenv("TROCAR_TEST_PLUGIN_RAN") != nullptr);

    const ComponentType* nudge = shelf.registry.find("Nudge");
    QVERIFY(nudge != nullptr);
    QCOMPARE(nudge->plugin, std::string("good"));
    const std::unique_ptr<Component> component = nudge->make();
    component->step({});
    const auto* force = dynamic_cast<const Output<double>*>(component->find_output("force"));
    QVERIFY(force != nullptr);
    QCOMPARE(**force, 1.5);

    const ServiceType& beacon = shelf.registry.services().front();
    QCOMPARE(beacon.plugin, std::string("good"));
    QCOMPARE(beacon.start({})->greeting(), std::string("seen from afar"));
  }

  void it_can_be_loaded_again_for_another_registry() {
    Shelf shelf;
    shelf.put("good");
    QCOMPARE(shelf.load().loaded.size(), std::size_t(1));
    Registry another;
    QCOMPARE(load_plugins(another, {shelf.searched()}).loaded.size(), std::size_t(1));
    QVERIFY(another.find("Nudge") != nullptr);
  }

  void another_build_is_refused_with_the_cure_data() {
    QTest::addColumn<int>("offset");
    QTest::addColumn<int>("value");
    QTest::addColumn<QString>("reason");  // what it begins with
    const PluginBuild own;
    const auto row = [](const char* name, std::size_t offset, int value, const QString& reason) {
      QTest::newRow(name) << int(offset) << value << reason;
    };
    const QString version = QString("%1.%2.%3").arg(own.trocar[0]).arg(own.trocar[1]);
    const QString here = version.arg(own.trocar[2]);
    const std::size_t minor = offsetof(PluginBuild, trocar) + sizeof(std::int32_t);
    row("an older Trocar", minor, own.trocar[1] - 1,
        QString("built with Trocar %1.%2.%3, this is %4: rebuild it with find_package(Trocar "
                "%1.%5)")
            .arg(own.trocar[0])
            .arg(own.trocar[1] - 1)
            .arg(own.trocar[2])
            .arg(here)
            .arg(own.trocar[1]));
    row("a newer Trocar", minor, own.trocar[1] + 1, "built with Trocar ");
    row("another layout of the record", offsetof(PluginBuild, interface), own.interface + 1,
        QString("built with Trocar %1 (plugin interface 2), this is %1 (plugin interface 1): "
                "rebuild it")
            .arg(here));
    row("another compiler", offsetof(PluginBuild, compiler_major), 99,
        QString("built with %1 99, Trocar with %1 %2: rebuild it with that compiler")
            .arg(own.compiler.data())
            .arg(own.compiler_major));
    row("another standard", offsetof(PluginBuild, standard), 202302,
        "built with C++ 202302, Trocar with C++ 202002: ");
    row("another Eigen", offsetof(PluginBuild, eigen), 9, "built with Eigen 9.");
    row("another alignment", offsetof(PluginBuild, alignment), 32,
        "built with Eigen aligned to 32 and 16 bytes, Trocar with Eigen aligned to 16 and 16 "
        "bytes: leave out -march=, -mavx");
    row("matrices by rows", offsetof(PluginBuild, row_major), 1,
        "built with matrices by rows (EIGEN_DEFAULT_TO_ROW_MAJOR), Trocar without: leave out");
    row("another standard library", offsetof(PluginBuild, libcpp), 1,
        "built with libc++, Trocar without: leave out -stdlib=libc++");
    row("old strings", offsetof(PluginBuild, old_strings), 1, "built with the strings of before");
    row("containers that check", offsetof(PluginBuild, checked_containers), 1,
        "built with containers that check (_GLIBCXX_DEBUG), Trocar without: ");
    row("no type information", offsetof(PluginBuild, type_information), 0,
        "built without type information, Trocar with: leave out -fno-rtti");
    row("no exceptions", offsetof(PluginBuild, exceptions), 0,
        "built without exceptions, Trocar with: leave out -fno-exceptions");
    row("another sanitizer", offsetof(PluginBuild, thread_sanitizer), 1 - own.thread_sanitizer,
        own.thread_sanitizer == 0 ? "built with ThreadSanitizer, Trocar without: leave out"
                                  : "built without ThreadSanitizer, Trocar with: compile with");
  }
  void another_build_is_refused_with_the_cure() {
    QFETCH(int, offset);
    QFETCH(int, value);
    QFETCH(QString, reason);
    Shelf shelf;
    shelf.write("good.so", rebuilt(std::size_t(offset), value));
    const QString said = only_reason(shelf.load());
    QVERIFY2(said.startsWith(reason), qPrintable(said));
    QVERIFY(shelf.registry.types().empty());
    // Nothing of it ran, not even what it does when it is loaded.
    QVERIFY(std::getenv("TROCAR_TEST_PLUGIN_RAN") == nullptr);
  }

  void a_newer_patch_fits() {
    Shelf shelf;
    shelf.write("good.so", rebuilt(offsetof(PluginBuild, trocar) + 2 * sizeof(std::int32_t), 77));
    // The file alone differs; what the plugin returns is read again after loading.
    QCOMPARE(shelf.load().loaded.size(), std::size_t(1));
  }

  void every_difference_is_told_at_once() {
    PluginBuild other;
    other.trocar = {9, 8, 7};
    other.compiler = {'C', 'r', 'a', 'y'};
    other.eigen = {5, 0, 0};
    other.old_strings = 1;
    const std::vector<std::string> found = differences(other, PluginBuild());
    QCOMPARE(found.size(), std::size_t(4));
    QVERIFY(found[1].starts_with("built with Cray "));
    QVERIFY(differences(PluginBuild(), PluginBuild()).empty());
    QVERIFY(differences(framework_build(), PluginBuild()).empty());
  }

  void what_is_no_plugin_is_refused_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("reason");  // what it begins with
    const auto row = [](const char* what, const char* reason) {
      QTest::newRow(what) << QString(what) << QString(reason);
    };
    row("text", "it is no shared library");
    row("empty", "it is no shared library");
    row("folder", "it is no file");
    row("link to nowhere", "there is no such file");
    row("library", "it is a library, but no plugin of Trocar: it needs trocar_plugin()");
    row("no function", "it exports no function trocar_plugin: include");
    row("other name", "it calls itself \"good\": it must be called like its file, \"odd\"");
    row("unknown symbol", "it cannot be loaded: undefined symbol: ");
  }
  void what_is_no_plugin_is_refused() {
    QFETCH(QString, what);
    QFETCH(QString, reason);
    Shelf shelf;
    QByteArray good = bytes_of(test_plugin("good"));
    if (what == "text")
      shelf.write("odd.so", "#!/bin/sh\necho hello\n");
    else if (what == "empty")
      shelf.write("odd.so", "");
    else if (what == "folder")
      QVERIFY(QDir(shelf.folder.path()).mkdir("odd.so"));
    else if (what == "link to nowhere")
      QVERIFY(QFile::link(shelf.path("nothing"), shelf.path("odd.so")));
    else if (what == "library")
      shelf.write("odd.so", bytes_of(TROCAR_COMPONENTS_LIBRARY));
    else if (what == "no function")
      shelf.write("odd.so", good.replace("trocar_plugin", "trocar_plugXn"));
    else if (what == "other name")
      shelf.write("odd.so", good);
    else  // as of a newer Trocar's library
      shelf.write("odd.so", good.replace("_ZN6trocar8Registry3add", "_ZN6trocar8Registry3adX"));
    const QString said = only_reason(shelf.load());
    QVERIFY2(said.startsWith(reason), qPrintable(said));
    QVERIFY(shelf.registry.types().empty());
  }

  void one_that_throws_leaves_nothing_behind() {
    Shelf shelf;
    shelf.put("throwing");
    QCOMPARE(only_reason(shelf.load()), QString("registering failed: the engine has no licence"));
    QVERIFY(shelf.registry.find("Half") == nullptr);
  }

  void one_that_says_nothing_of_itself_is_told_all_that_is_missing() {
    Shelf shelf;
    shelf.put("bare");
    const Plugins plugins = shelf.load();
    QCOMPARE(plugins.refused.size(), std::size_t(1));
    QCOMPARE(plugins.refused.front().reasons,
             (std::vector<std::string>{"it does not say its version", "it does not say its licence",
                                       "it does not say in one line what it is",
                                       "it registers nothing: give it register_with"}));
  }

  void a_name_that_is_taken_is_refused_with_its_owner() {
    Shelf shelf;
    for (const char* name : {"good", "twin"}) shelf.put(name);
    const Plugins plugins = shelf.load();
    QCOMPARE(plugins.loaded.size(), std::size_t(1));
    QCOMPARE(plugins.refused.size(), std::size_t(1));
    QCOMPARE(plugins.refused.front().reasons,
             (std::vector<std::string>{
                 "its component \"Nudge\" is one of plugin good already: give it another name",
                 "its service \"beacon\" is one of plugin good already: give it another name"}));
    QVERIFY2(shelf.registry.find("Twin") == nullptr, "a plugin is taken as a whole");
  }

  void a_name_of_trocar_s_own_is_taken_too() {
    Shelf shelf;
    shelf.put("good");
    Registry first;
    load_plugins(first, {shelf.searched()});
    ComponentType own = *first.find("Nudge");
    own.plugin.clear();
    shelf.registry.add(own);
    QCOMPARE(only_reason(shelf.load()),
             QString("its component \"Nudge\" is one of Trocar's own already: give it another "
                     "name"));
  }

  void one_that_is_refused_hinders_no_other() {
    Shelf shelf;
    for (const char* name : {"bare", "good", "throwing"}) shelf.put(name);
    shelf.write("aaa.so", "text");
    shelf.write("README.txt", "is not looked at");
    const Plugins plugins = shelf.load();
    QCOMPARE(plugins.loaded.size(), std::size_t(1));
    QCOMPARE(plugins.refused.size(), std::size_t(3));
    QCOMPARE(plugins.refused.front().file.filename().string(), std::string("aaa.so"));
  }

  void the_earlier_folder_wins() {
    Shelf early, late;
    early.put("good");
    late.write("good.so", "text");
    Plugins plugins = load_plugins(early.registry, {early.searched(), late.searched()});
    QCOMPARE(plugins.loaded.size(), std::size_t(1));
    QVERIFY(plugins.refused.empty());
    plugins = load_plugins(late.registry, {late.searched(), early.searched()});
    QVERIFY2(plugins.loaded.empty(), "a broken one hides a good one: no surprise later");
    QCOMPARE(plugins.refused.size(), std::size_t(1));
  }

  void a_folder_that_is_not_there_is_told_to_who_asked_for_it() {
    Shelf shelf;
    const QString missing = shelf.path("missing");
    QVERIFY(load_plugins(shelf.registry, {{missing.toStdString(), false}}).refused.empty());
    const Plugins plugins = load_plugins(shelf.registry, {{missing.toStdString(), true}});
    QCOMPARE(only_reason(plugins), QString("it cannot be searched: No such file or directory"));
    QCOMPARE(QString::fromStdString(plugins.refused.front().file.string()), missing);
  }

  void the_search_path_ends_beside_the_library() {
    const std::vector<PluginFolder> folders = plugin_folders("/a::b:");
    QCOMPARE(folders.size(), std::size_t(3));
    QCOMPARE(folders[0].path.string(), std::string("/a"));
    QCOMPARE(folders[1].path.string(), std::string("b"));
    QVERIFY(folders[0].asked_for && folders[1].asked_for && !folders[2].asked_for);
    QCOMPARE(folders[2].path,
             std::filesystem::canonical(TROCAR_LIBRARY).parent_path() / "trocar" / "plugins");
    QCOMPARE(plugin_folders("").size(), std::size_t(1));
  }
};

QTEST_APPLESS_MAIN(TestPluginLoader)
#include "tst_plugin_loader.moc"
