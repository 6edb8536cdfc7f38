// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFile>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

#include "components/register.hpp"
#include "framework/scripting/script.hpp"

namespace trocar::test {

/// What came of a script: its findings as "3: message" ("--set: message" for options), and the
/// session that it left.
struct ScriptOutcome {
  QStringList findings;
  std::unique_ptr<Registry> registry;
  std::unique_ptr<Session> session;
};

/// Runs the file with settings as of --set.
inline ScriptOutcome run_script_file(const QString& path, const QStringList& settings = {},
                                     SessionOptions options = {},
                                     ClockKind clock = ClockKind::simulated) {
  options.clock = clock;
  options.default_duration = 0.01;
  Graph::Overrides arguments;
  for (const QString& setting : settings) {
    const std::string key = setting.section('=', 0, 0).toStdString();
    auto& target = key.find('.') == std::string::npos ? arguments : options.set;
    const std::string value = setting.section('=', 1).toStdString();
    target.insert_or_assign(key, Graph::Override{literal_from_text(value), {"--set", 0}});
  }
  ScriptOutcome outcome{.findings = {}, .registry = std::make_unique<Registry>(), .session = {}};
  register_components(*outcome.registry);
  outcome.session = std::make_unique<Session>(*outcome.registry, std::move(options));
  try {
    run_script(*outcome.session, path.toStdString(), std::move(arguments));
  } catch (const BrokenGraph& broken) {
    for (const Finding& finding : broken.findings.all())
      outcome.findings << (finding.where.line > 0 ? QString::number(finding.where.line)
                                                  : QString::fromStdString(finding.where.file)) +
                              ": " + QString::fromStdString(finding.message);
  }
  outcome.session->finish();
  return outcome;
}

/// Writes the text to a file of its own and runs it.
inline ScriptOutcome run_script_text(const QByteArray& text, const QStringList& settings = {},
                                     SessionOptions options = {},
                                     ClockKind clock = ClockKind::simulated) {
  const QTemporaryDir folder;
  QFile file(folder.filePath("script.lua"));
  if (!file.open(QFile::WriteOnly) || file.write(text) != text.size()) return {};
  file.close();
  return run_script_file(file.fileName(), settings, std::move(options), clock);
}

/// Whether there are as many findings as expected, each with the text of its place in the list.
inline bool match(const QStringList& findings, const QStringList& expected) {
  if (findings.size() != expected.size()) return false;
  for (int i = 0; i < findings.size(); ++i)
    if (!findings[i].startsWith(expected[i].section(' ', 0, 0)) ||
        !findings[i].contains(expected[i].section(' ', 1)))
      return false;
  return true;
}

}  // namespace trocar::test
