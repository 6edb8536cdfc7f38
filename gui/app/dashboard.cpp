// SPDX-License-Identifier: Apache-2.0
#include "gui/app/dashboard.hpp"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include "gui/window/pages.hpp"

namespace trocar::gui {
namespace {

/// The script's name, and of its text what tells one version from another.
QString mark_of(const QString& script) {
  QFile file(script);
  if (!file.open(QFile::ReadOnly)) return QFileInfo(script).fileName();
  const QByteArray hash = QCryptographicHash::hash(file.readAll(), QCryptographicHash::Sha256);
  return QString("%1 %2").arg(QFileInfo(script).fileName(), QString(hash.toHex().left(8)));
}

}  // namespace

Dashboard::Dashboard() = default;

void Dashboard::open_window(const QString& subject) {
  operator_ = std::make_unique<Operator>(Sources{data_, &link_, &live_});
  window_ = std::make_unique<MainWindow>(*operator_, subject);
  add_pages(*window_, *operator_);
}

void Dashboard::run(const QString& script, const QStringList& options) {
  open_window(QFileInfo(script).fileName());
  window_->set_mark(mark_of(script));
  runtime_ = std::make_unique<Runtime>();
  connect(runtime_.get(), &Runtime::serving, this, [this](const QUrl& url) { link_.open(url); });
  connect(runtime_.get(), &Runtime::ended, this, [this](const QString& why) {
    const QString last = runtime_->said().trimmed().section('\n', -1);
    window_->state_strip().say(QString("the runtime ended, %1: %2").arg(why, last));
  });
  // It does not answer, so its device's watchdog has to do it.
  connect(&operator_->stop_control(), &StopControl::not_confirmed, runtime_.get(), &Runtime::kill);
  runtime_->start(script, options);
}

void Dashboard::attach(const QUrl& url) {
  open_window(url.toString(QUrl::RemoveQuery));
  link_.open(url);
}

}  // namespace trocar::gui
