// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QUrl>

namespace trocar::gui {

/// `trocar run SCRIPT --serve` as a process of the dashboard's own, which ends with it. It shares
/// nothing else with it: if the dashboard hangs or dies, the haptic loop does not notice.
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
  void ended(const QString& why);

 private:
  void read();

  QProcess process_;
  QString said_;
  bool serving_ = false;
};

/// A program that is installed beside this one.
QString beside(const QString& program);

}  // namespace trocar::gui
