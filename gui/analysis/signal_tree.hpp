// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStandardItemModel>
#include <QStringList>

#include "gui/data/data_store.hpp"

namespace trocar::gui {

/// All signals of a run by the parts of their names: wall → force → z, with unit and newest value.
/// What is chosen can be dragged, a part with all that is below it.
class SignalTree : public QStandardItemModel {
  Q_OBJECT

 public:
  static constexpr const char* mime_type = "application/x-trocar-signals";  // a name on each line
  enum Column { name, value };
  enum Role { signal_role = Qt::UserRole, path_role };  // whole name of a signal; of any part

  explicit SignalTree(DataStore& data, QObject* parent = nullptr);

  /// Names of the signals at and below `index`, in order.
  QStringList signals_below(const QModelIndex& index) const;
  QStringList names_of(const QModelIndexList& indexes) const;  // without repeats

  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QStringList mimeTypes() const override { return {mime_type}; }
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  int count() const { return count_; }  // of signals

 Q_SIGNALS:
  void filled();

 private:
  void fill();
  QStandardItem* child(QStandardItem* parent, const QString& text);

  DataStore& data_;
  int count_ = 0;
};

}  // namespace trocar::gui
