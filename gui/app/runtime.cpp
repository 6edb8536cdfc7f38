// SPDX-License-Identifier: Apache-2.0
#include "gui/app/runtime.hpp"

#include <signal.h>
#include <sys/prctl.h>

#include <QCoreApplication>
#include <QDir>
#include <QRegularExpression>

namespace trocar::gui {
namespace {

constexpr int patience_ms = 5000;
constexpr qsizetype most_said = 64 * 1024;  // the end of what it says is what matters

}  // namespace

QString beside(const QString& program) {
  return QDir(QCoreApplication::applicationDirPath()).filePath(program);
}

Runtime::Runtime(QObject* parent) : QObject(parent) {
  process_.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGTERM); });
  process_.setProcessChannelMode(QProcess::MergedChannels);
  connect(&process_, &QProcess::readyRead, this, &Runtime::read);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) Q_EMIT ended(process_.errorString(), false);
  });
  connect(&process_, &QProcess::finished, this, [this](int code, QProcess::ExitStatus status) {
    read();
    const bool by_force = status == QProcess::CrashExit;
    Q_EMIT ended(by_force ? QString("by force") : QString("status %1").arg(code), by_force);
  });
}

Runtime::~Runtime() {
  disconnect(&process_, nullptr, this, nullptr);
  end();
}

void Runtime::start(const QString& script, const QStringList& options) {
  said_.clear();
  serving_ = false;
  process_.start(beside("trocar"), QStringList{"run", script, "--serve", "127.0.0.1:0"} + options);
}

void Runtime::read() {
  said_ += QString::fromUtf8(process_.readAll());
  if (said_.size() > most_said) said_ = said_.right(most_said);
  if (serving_) return;
  static const QRegularExpression greeting("serving (ws://[^\\s]+)");
  const auto found = greeting.match(said_);
  if (!found.hasMatch()) return;
  serving_ = true;
  Q_EMIT serving(QUrl(found.captured(1)));
}

void Runtime::end() {
  if (!running()) return;
  process_.terminate();
  if (!process_.waitForFinished(patience_ms)) kill();
}

void Runtime::kill() {
  process_.kill();
  process_.waitForFinished(patience_ms);
}

}  // namespace trocar::gui
