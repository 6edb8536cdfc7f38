// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/alarms_page.hpp"

#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

namespace trocar::gui {

AlarmsPage::AlarmsPage(Operator& operators, QWidget* parent)
    : Page(parent),
      operator_(operators),
      events_(operators.sources().data),
      remark_(new QLineEdit(this)) {
  setObjectName("alarms_page");
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(new QLabel("<b>Alarms</b>, the first cause on top"));
  QTableView* alarms = table("alarm_table", "alarms", &operator_.alarms());
  layout->addWidget(alarms, 1);
  alarms->setColumnWidth(AlarmModel::cause, 420);
  alarms->setColumnWidth(AlarmModel::source, 180);
  alarms->setColumnWidth(AlarmModel::value, 220);
  layout->addWidget(new QLabel("<b>Events</b>"));
  QTableView* events = table("event_table", "events", &events_);
  layout->addWidget(events, 2);
  events->setColumnWidth(EventModel::kind, 160);
  events->setColumnWidth(EventModel::source, 180);
  remark_->setObjectName("annotation");
  remark_->setAccessibleName("remark into the log");
  remark_->setPlaceholderText("a remark, Enter writes it into the log with its tick");
  remark_->setEnabled(operator_.sources().link != nullptr);
  layout->addWidget(remark_);
  connect(remark_, &QLineEdit::returnPressed, this, [this] {
    operator_.annotate(remark_->text());
    remark_->clear();
  });
  connect(&events_, &EventModel::rowsInserted, events, &QTableView::scrollToBottom);
}

QTableView* AlarmsPage::table(const char* name, const QString& accessible,
                              QAbstractItemModel* model) {
  auto* view = new QTableView(this);
  view->setModel(model);
  view->setObjectName(name);
  view->setAccessibleName(accessible);
  view->setSelectionBehavior(QAbstractItemView::SelectRows);
  view->setAlternatingRowColors(true);
  view->setTabKeyNavigation(false);  // the tab key leads on, arrows move in it
  view->verticalHeader()->hide();
  view->horizontalHeader()->setStretchLastSection(true);
  return view;
}

void AlarmsPage::begin_remark() {
  remark_->setFocus(Qt::ShortcutFocusReason);
}

}  // namespace trocar::gui
