// SPDX-License-Identifier: Apache-2.0
#include "gui/operate/alarms.hpp"

#include <algorithm>

namespace trocar::gui {

AlarmModel::AlarmModel(DataStore& data, QObject* parent)
    : QAbstractTableModel(parent), store_(data) {
  connect(&store_, &DataStore::run_began, this, &AlarmModel::clear);
  connect(&store_, &DataStore::event_added, this, [this](const RunEvent& event) {
    if (store_.events_shown() < store_.events().size())
      return;  // refresh() takes it when it is due
    shown_ = store_.events().size();
    take(event);
  });
  refresh();
}

void AlarmModel::refresh() {
  const std::size_t shown = store_.events_shown();
  if (shown == shown_) return;
  if (shown < shown_) clear();
  while (shown_ < shown) take(store_.events()[shown_++]);
}

void AlarmModel::clear() {
  beginResetModel();
  alarms_.clear();
  shown_ = 0;
  refused_tick_ = -1;
  endResetModel();
  Q_EMIT changed();
}

void AlarmModel::take(const RunEvent& event) {
  if (event.kind == "fault") take_fault(event);
  if (event.kind == "acknowledged") acknowledge(event);
  if (event.kind == "acknowledge refused" && !event.source.empty()) refuse(event);
}

void AlarmModel::take_fault(const RunEvent& event) {
  const QString from = QString::fromStdString(event.source);
  const QString what = QString::fromStdString(event.detail);
  const auto same = std::find_if(alarms_.begin(), alarms_.end(), [&](const Alarm& one) {
    return !one.acknowledged && one.source == from && one.cause == what;
  });
  if (same == alarms_.end()) {
    const int row = static_cast<int>(alarms_.size());
    beginInsertRows({}, row, row);
    alarms_.push_back({.tick = event.tick,
                       .time = event.time,
                       .source = from,
                       .cause = what,
                       .value = event.value,
                       .limit = event.limit,
                       .count = 1,
                       .last_time = event.time,
                       .acknowledged = false,
                       .acknowledged_at = -1});
    endInsertRows();
  } else {
    ++same->count;
    same->last_time = event.time;
    const int row = static_cast<int>(same - alarms_.begin());
    Q_EMIT dataChanged(index(row, 0), index(row, columns - 1));
  }
  Q_EMIT changed();
}

/// Of several devices each answers, and faults stay latched until all of them have acknowledged.
void AlarmModel::acknowledge(const RunEvent& event) {
  if (alarms_.empty() || event.tick == refused_tick_) return;
  for (Alarm& alarm : alarms_) {
    if (alarm.acknowledged) continue;
    alarm.acknowledged = true;
    alarm.acknowledged_at = event.tick;
  }
  Q_EMIT dataChanged(index(0, 0), index(static_cast<int>(alarms_.size()) - 1, columns - 1));
  Q_EMIT changed();
}

void AlarmModel::refuse(const RunEvent& event) {
  refused_tick_ = event.tick;
  bool any = false;
  for (Alarm& alarm : alarms_) {
    if (!alarm.acknowledged || alarm.acknowledged_at != event.tick) continue;
    alarm.acknowledged = false;
    alarm.acknowledged_at = -1;
    any = true;
  }
  if (!any) return;
  Q_EMIT dataChanged(index(0, 0), index(static_cast<int>(alarms_.size()) - 1, columns - 1));
  Q_EMIT changed();
}

const Alarm* AlarmModel::first() const {
  for (const Alarm& alarm : alarms_)
    if (!alarm.acknowledged) return &alarm;
  return nullptr;
}

QString AlarmModel::text(const Alarm& alarm, double now) {
  QString text = QString("%1 s ago, tick %2").arg(now - alarm.time, 0, 'f', 0).arg(alarm.tick);
  if (alarm.count > 1) text += QString(", %1 times").arg(alarm.count);
  text += QString("  %1: %2").arg(alarm.source, alarm.cause);
  if (alarm.limit != 0.0)
    text += QString(" (%1, limit %2)").arg(alarm.value, 0, 'g', 4).arg(alarm.limit, 0, 'g', 4);
  return text;
}

int AlarmModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(alarms_.size());
}

int AlarmModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant AlarmModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Alarm& alarm = alarms_[static_cast<std::size_t>(index.row())];
  if (role == Qt::TextAlignmentRole && (index.column() == time || index.column() == count))
    return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case time:
      return QString("%1 s").arg(alarm.time, 0, 'f', 3);
    case cause:
      return alarm.cause;
    case source:
      return alarm.source;
    case value:
      return alarm.limit == 0.0
                 ? QString()
                 : QString("%1, limit %2").arg(alarm.value, 0, 'g', 4).arg(alarm.limit, 0, 'g', 4);
    case count:
      return alarm.count;
    case state:
      return alarm.acknowledged ? QString("acknowledged") : QString("LATCHED");
    default:
      return {};
  }
}

QVariant AlarmModel::headerData(int section, Qt::Orientation orientation, int role) const {
  static const char* const names[] = {"time", "cause", "component", "value", "times", "state"};
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole || section >= columns) return {};
  return QString(names[section]);
}

}  // namespace trocar::gui
