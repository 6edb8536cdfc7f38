// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLineEdit>
#include <QTableView>

#include "gui/operate/events.hpp"
#include "gui/operate/operator.hpp"

namespace trocar::gui {

/// Alarms, the first cause on top, above all events; and remarks into the log.
class AlarmsPage : public Page {
  Q_OBJECT

 public:
  explicit AlarmsPage(Operator& operators, QWidget* parent = nullptr);

  QString title() const override { return "Alarms and events"; }
  QKeySequence shortcut() const override { return QKeySequence("Ctrl+4"); }
  void refresh() override { events_.refresh(); }
  void set_theme(const Theme&) override {}
  /// Puts the cursor where a remark is typed.
  void begin_remark();

 private:
  QTableView* table(const char* name, const QString& accessible, QAbstractItemModel* model);

  Operator& operator_;
  EventModel events_;
  QLineEdit* remark_;
};

}  // namespace trocar::gui
