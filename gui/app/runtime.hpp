// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QUrl>

namespace trocar::gui {

/// `trocar run SCRIPT --serve` as a process of the dashboard's own. It shares nothing with it, and
/// its loop does not notice when the dashboard hangs. It ends with the dashboard, in order, also
/// when that dies: nobody could stop it any more.
class Runtime : public QObject {
  Q_OBJECT

 public:
  explicit Runtime(QObject* parent = nullptr);
  ~Runtime() override;

  /// @param options of `trocar run`
  void start(const QString& script, const QStringList& options);
  bool running() const { return process_.state() != QProcess::NotRunning; }
  /// In order, with its report; then by force.
  void end();
  /// At once: it does not answer.
  void kill();
  qint64 pid() const { return process_.processId(); }
  const QString& said() const { return said_; }  // on its two outputs

 Q_SIGNALS:
  void serving(const QUrl& url);
  /// @param by_force it did not end in order, and what its device does is not known
  void ended(const QString& why, bool by_force);

 private:
  void read();

  QProcess process_;
  QString said_;
  bool serving_ = false;
};

/// A program that is installed beside this one.
QString beside(const QString& program);

}  // namespace trocar::gui
