// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>

#include "gui/data/data_store.hpp"

namespace trocar::gui {

/// What happened in a run, the newest last: annotations, edits, faults, reloads, …
class EventModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { time, tick, kind, source, detail, columns };

  explicit EventModel(DataStore& store, QObject* parent = nullptr);
  /// Playback: what lies behind the place where it stands is not shown.
  void refresh();

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation,
                      int role = Qt::DisplayRole) const override;

 private:
  void reset();

  DataStore& store_;
  int rows_ = 0;
};

}  // namespace trocar::gui
