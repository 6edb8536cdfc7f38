// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace trocar::gui {

/// What a dashboard shows that was started with nothing to look at: what to do next.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);

 Q_SIGNALS:
  void script_chosen(const QString& file);
  void address_chosen(const QString& url);
  void log_chosen(const QString& file);
};

/// A script of those that come with Trocar, in the source tree or installed; "" when it is not
/// found.
QString shipped_script(const QString& name);

}  // namespace trocar::gui
