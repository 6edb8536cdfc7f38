// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFileInfo>

#include "tests/support/script_bench.hpp"

namespace trocar::test {

/// What came of a script that uses a law: everything that was said about the law's file, as
/// "law.lua:3: message", findings first, then faults.
struct LawOutcome {
  QStringList said;
  ScriptOutcome script;

  const RunResult& run() const { return script.session->runs().back()->result; }
};

inline const QByteArray law_scene =
    "local laparoscope = trocar.Laparoscope { hand = \"none\" }\n"
    "local sine = trocar.Sine { amplitude = \"1 N\", frequency = \"5 Hz\" }\n";

/// Runs the script in virtual time, in a folder that has the law beside it as law.lua.
inline LawOutcome run_law(const QByteArray& law, const QByteArray& script,
                          const QStringList& settings = {}, SessionOptions options = {}) {
  LawOutcome outcome;
  const QTemporaryDir folder;
  const auto write = [&](const char* name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    return file.open(QFile::WriteOnly) && file.write(text) == text.size();
  };
  if (!write("law.lua", law) || !write("script.lua", script)) return outcome;
  outcome.script = run_script_file(folder.filePath("script.lua"), settings, std::move(options));
  for (const Finding& finding : outcome.script.session->graph().findings().all())
    outcome.said << QFileInfo(QString::fromStdString(finding.where.file)).fileName() +
                        QString(":%1: ").arg(finding.where.line) +
                        QString::fromStdString(finding.message);
  for (const auto& run : outcome.script.session->runs())
    for (const FaultRecord& fault : run->result.faults)
      outcome.said << QString::fromStdString(fault.detail);
  return outcome;
}

/// A fixture with this body of step, at the tip of a laparoscope.
inline LawOutcome run_step(const QByteArray& body) {
  return run_law(
      "return trocar.fixture {\n"
      "  parameters = { stiffness = { \"2 N/mm\" } },\n"
      "  outputs = { depth = \"m\" }, state = { torn = false },\n"
      "  step = function(p, at, out, state)\n" +
          body + "\n  end }\n",
      law_scene + "trocar.LuaFixture { file = \"law.lua\", at = laparoscope.tip }");
}

}  // namespace trocar::test
