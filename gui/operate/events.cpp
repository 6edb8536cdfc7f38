// SPDX-License-Identifier: Apache-2.0
#include "gui/operate/events.hpp"

namespace trocar::gui {

EventModel::EventModel(DataStore& store, QObject* parent)
    : QAbstractTableModel(parent), store_(store), rows_(static_cast<int>(store.events_shown())) {
  connect(&store_, &DataStore::event_added, this, [this] {
    const bool oldest_went = rows_ == static_cast<int>(store_.events().size());
    oldest_went&& rows_ == static_cast<int>(store_.events_shown()) ? reset() : refresh();
  });
  connect(&store_, &DataStore::run_began, this, &EventModel::reset);
}

void EventModel::reset() {
  beginResetModel();
  rows_ = static_cast<int>(store_.events_shown());
  endResetModel();
}

void EventModel::refresh() {
  const int now = static_cast<int>(store_.events_shown());
  if (now < rows_) return reset();
  if (now == rows_) return;
  beginInsertRows({}, rows_, now - 1);
  rows_ = now;
  endInsertRows();
}

int EventModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : rows_;
}

int EventModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant EventModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rows_ || role != Qt::DisplayRole) return {};
  const RunEvent& event = store_.events()[static_cast<std::size_t>(index.row())];
  switch (index.column()) {
    case time:
      return QString("%1 s").arg(event.time, 0, 'f', 3);
    case tick:
      return static_cast<qint64>(event.tick);
    case kind:
      return QString::fromStdString(event.kind);
    case source:
      return QString::fromStdString(event.source);
    case detail:
      return QString::fromStdString(event.detail);
    default:
      return {};
  }
}

QVariant EventModel::headerData(int section, Qt::Orientation orientation, int role) const {
  static const char* const names[] = {"time", "tick", "event", "of", "what"};
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole || section >= columns) return {};
  return QString(names[section]);
}

}  // namespace trocar::gui
