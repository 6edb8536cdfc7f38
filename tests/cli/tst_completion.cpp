// SPDX-License-Identifier: Apache-2.0
// `trocar completion`: what a real bash offers after each line, and that other shells read theirs.
#include <QDir>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/trocar_process.hpp"

using namespace trocar::test;

namespace {

/// What bash offers for the last of the words, sorted.
QStringList offered(const QStringList& words) {
  QProcess bash;
  bash.start("bash", QStringList{"--norc", "-c",
                                 "source <(\"$0\" completion bash) || exit\n"
                                 "COMP_WORDS=(trocar \"$@\") COMP_CWORD=$#\n"
                                 "_trocar \"$0\" \"${@: -1}\" \"${COMP_WORDS[$# - 1]}\" || :\n"
                                 "printf '%s\\n' \"${COMPREPLY[@]}\"",
                                 TROCAR_BINARY} +
                         words);
  if (!bash.waitForFinished(60'000) || bash.exitCode() != 0) return {"bash failed"};
  if (const QByteArray said = bash.readAllStandardError(); !said.isEmpty())
    return {QString::fromUtf8(said)};
  QStringList list =
      QString::fromUtf8(bash.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
  list.sort();
  return list;
}

}  // namespace

class TestCompletion : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(TROCAR_SOURCE_DIR)); }

  void bash_offers_data() {
    QTest::addColumn<QStringList>("words");  // after "trocar"; the last is being written
    QTest::addColumn<QStringList>("wanted");
    const auto row = [](const char* name, const QStringList& words, const QStringList& wanted) {
      QTest::newRow(name) << words << wanted;
    };
    const QString wall = "scripts/tutorial/01_feel_a_wall.lua";
    row("commands", {"li"}, {"list"});
    row("commands of a command", {"kinematics", ""},
        {"dynamics", "fk", "gravity", "ik", "jacobian"});
    row("options", {"run", "--cl"}, {"--clock"});
    row("options behind an operand", {"run", wall, "--re"}, {"--record"});
    row("options where nothing else can follow", {"describe", "Wall", ""},
        {"--help", "--json", "-h"});
    row("options of a command below", {"kinematics", "fk", "-"}, {"--help", "-h"});
    row("options of trocar itself", {"--v"}, {"--version"});
    row("choices", {"run", wall, "--clock", ""}, {"device", "realtime", "simulated"});
    row("choices behind an equals sign", {"run", "--clock", "=", "s"}, {"simulated"});
    row("choices right behind an equals sign", {"run", "--clock", "="},
        {"device", "realtime", "simulated"});
    row("choices of an operand", {"completion", ""}, {"bash", "fish", "zsh"});
    row("what can be listed", {"list", "pl"}, {"plugins"});
    row("formats of a graph", {"graph", wall, "--format", "m"}, {"mermaid"});
    row("scripts", {"check", "scripts/tutorial/01"}, {wall});
    row("scripts, behind an option with a value", {"run", "--for", "5s", "scripts/tutorial/01"},
        {wall});
    row("folders on the way to a script", {"check", "scripts/"},
        {"scripts/dev", "scripts/experiments", "scripts/fixtures", "scripts/layouts",
         "scripts/tutorial"});
    row("no other file for a script", {"check", "READ"}, {});
    row("any file where any will do", {"graph", wall, "-o", "READ"}, {"README.md"});
    row("components", {"describe", "Wal"}, {"Wall"});
    row("nothing where nobody knows", {"run", "--for", ""}, {});
    row("nothing for an unknown command", {"rnu", "--cl"}, {});
  }
  void bash_offers() {
    QFETCH(QStringList, words);
    QFETCH(QStringList, wanted);
    QCOMPARE(offered(words), wanted);
  }

  void bash_offers_every_command_and_option_of_the_help() {
    static const QRegularExpression first("^  ([a-z]+) {2,}", QRegularExpression::MultilineOption);
    static const QRegularExpression option("^  (?:-\\w,)?(--[a-z-]+)",
                                           QRegularExpression::MultilineOption);
    const QString help = QString::fromUtf8(run_trocar({"--help"}).out);
    const QString commands = help.mid(help.indexOf("Subcommands:"));
    QStringList names;
    for (auto each = first.globalMatch(commands); each.hasNext();) names << each.next().captured(1);
    QVERIFY(names.size() >= 8);
    for (const QString& name : names) {
      QVERIFY2(offered({name}).contains(name), qPrintable(name));
      const QString text = QString::fromUtf8(run_trocar({name, "--help"}).out);
      for (auto each = option.globalMatch(text); each.hasNext();) {
        const QString flag = each.next().captured(1);
        QVERIFY2(offered({name, flag}).contains(flag), qPrintable(name + " " + flag));
      }
    }
  }

  void a_name_with_a_blank_stays_one() {
    const QTemporaryDir folder;
    QFile file(folder.filePath("two words.lua"));
    QVERIFY(file.open(QFile::WriteOnly));
    QCOMPARE(offered({"run", folder.filePath("two")}), QStringList{file.fileName()});
  }

  void bash_is_told_to_call_it() {
    QProcess bash;
    bash.start("bash", {"--norc", "-c", "source <(\"$0\" completion bash); complete -p trocar",
                        TROCAR_BINARY});
    QVERIFY(bash.waitForFinished(60'000));
    QCOMPARE(bash.readAllStandardOutput(), QByteArray("complete -F _trocar trocar\n"));
  }

  void each_shell_reads_its_script_data() {
    QTest::addColumn<QString>("shell");
    for (const char* shell : {"bash", "zsh", "fish"}) QTest::newRow(shell) << shell;
  }
  void each_shell_reads_its_script() {
    QFETCH(QString, shell);
    const Ran ran = run_trocar({"completion", shell});
    QCOMPARE(ran.status, 0);
    for (const char* name : {"mermaid", "simulated", "jacobian", "list --names"})
      QVERIFY2(ran.out.contains(name), name);
    if (QStandardPaths::findExecutable(shell).isEmpty()) QSKIP("this shell is not installed");
    const QTemporaryDir folder;
    QFile file(folder.filePath("script"));
    QVERIFY(file.open(QFile::WriteOnly) && file.write(ran.out) == ran.out.size());
    file.close();
    QProcess process;
    process.start(shell, {"-n", file.fileName()});
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.readAllStandardError(), QByteArray());
    QCOMPARE(process.exitCode(), 0);
  }

  void fish_offers_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QByteArray>("wanted");
    QTest::newRow("commands") << "trocar lis" << QByteArray("list");
    QTest::newRow("choices") << "trocar run --clock s" << QByteArray("simulated");
    QTest::newRow("components") << TROCAR_BINARY " describe Wal" << QByteArray("Wall");
    QTest::newRow("scripts") << "trocar check scripts/tutorial/01"
                             << QByteArray("scripts/tutorial/01_feel_a_wall.lua");
    QTest::newRow("nothing where nobody knows") << "trocar run --for " << QByteArray();
  }
  void fish_offers() {
    QFETCH(QString, line);
    QFETCH(QByteArray, wanted);
    if (QStandardPaths::findExecutable("fish").isEmpty()) QSKIP("fish is not installed");
    const QTemporaryDir home;
    QProcess fish;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("HOME", home.path());
    fish.setProcessEnvironment(environment);
    fish.start(
        "fish",
        {"-c", QString("%1 completion fish | source; complete -C '%2'").arg(TROCAR_BINARY, line)});
    QVERIFY(fish.waitForFinished(60'000));
    QCOMPARE(fish.readAllStandardError(), QByteArray());
    QCOMPARE(fish.readAllStandardOutput().split('\t').first().trimmed(), wanted);
  }

  void another_shell_is_refused() {
    const Ran ran = run_trocar({"completion", "tcsh"});
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.contains("tcsh not in {bash,zsh,fish}"), ran.err);
  }
};

QTEST_GUILESS_MAIN(TestCompletion)
#include "tst_completion.moc"
