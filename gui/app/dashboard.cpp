// SPDX-License-Identifier: Apache-2.0
#include "gui/app/dashboard.hpp"

#include <QFileInfo>

#include "gui/window/pages.hpp"

namespace trocar::gui {

Dashboard::Dashboard() = default;

void Dashboard::open_window(const QString& subject) {
  operator_ = std::make_unique<Operator>(Sources{data_, &link_, &live_});
  window_ = std::make_unique<MainWindow>(*operator_, subject);
  add_pages(*window_, *operator_);
}

void Dashboard::run(const QString& script, const QStringList& options) {
  open_window(QFileInfo(script).fileName());
  runtime_ = std::make_unique<Runtime>();
  connect(runtime_.get(), &Runtime::serving, this, [this](const QUrl& url) { link_.open(url); });
  connect(runtime_.get(), &Runtime::ended, this, &Dashboard::hear_end);
  // It does not answer, so its device's watchdog has to do it.
  connect(&operator_->stop_control(), &StopControl::not_confirmed, runtime_.get(), &Runtime::kill);
  runtime_->start(script, options);
}

/// It would otherwise connect to whoever gets that port next.
void Dashboard::hear_end(const QString& why, bool by_force) {
  link_.close();
  operator_->set_runtime_ended(!by_force);
  const QString last = runtime_->said().trimmed().section('\n', -1).trimmed();
  QString notice = QString("The run has ended: %1").arg(why);
  if (by_force)
    notice += ". Only the device's own watchdog ends its effort";
  else if (!last.isEmpty())
    notice += ". It said: " + last;
  window_->state_strip().set_notice(notice);
}

void Dashboard::attach(const QUrl& url) {
  const QString where = url.toString(QUrl::RemoveQuery);
  open_window(where);
  connect(&link_, &StreamClient::state_changed, this, [this, where] {
    const bool never = data_.tracks().empty() && link_.state() == LinkState::connecting;
    window_->state_strip().set_notice(
        !never ? QString()
               : QString("No connection to %1: %2. It is tried again twice a second.")
                     .arg(where, QString::fromStdString(link_.why())));
  });
  link_.open(url);
}

}  // namespace trocar::gui
