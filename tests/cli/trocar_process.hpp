// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QProcess>
#include <QStringList>

namespace trocar::test {

/// What a run of the built `trocar` left behind.
struct Ran {
  int status = -1;  // -1: it crashed or hung
  QByteArray out;
  QByteArray err;
};

inline Ran run_trocar(const QStringList& arguments, const QByteArray& input = {}) {
  QProcess process;
  process.start(TROCAR_BINARY, arguments);
  process.write(input);
  process.closeWriteChannel();
  const bool ended =
      process.waitForFinished(60'000) && process.exitStatus() == QProcess::NormalExit;
  return {ended ? process.exitCode() : -1, process.readAllStandardOutput(),
          process.readAllStandardError()};
}

/// Whether util-linux's `script` can give a program a terminal; a bare chroot has no /dev/pts.
inline bool terminals_are_possible() {
  QProcess process;
  process.start("script", {"-qec", "true", "/dev/null"});
  return process.waitForFinished(60'000) && process.exitCode() == 0;
}

}  // namespace trocar::test
