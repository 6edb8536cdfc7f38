// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <cstdint>
#include <vector>

#include "gui/data/data_store.hpp"

namespace trocar::gui {

/// A cause that was told by a fault, however often.
struct Alarm {
  std::int64_t tick = 0;  // when it came first
  double time = 0.0;      // [s]
  QString source, cause;
  double value = 0.0, limit = 0.0;
  int count = 1;
  double last_time = 0.0;  // [s]
  bool acknowledged = false;
  std::int64_t acknowledged_at = -1;  // tick
};

/// The faults of a run, the first cause on top. They stay until they are acknowledged, and the
/// runtime acknowledges them only when what caused them is gone.
class AlarmModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { time, cause, source, value, count, state, columns };

  explicit AlarmModel(DataStore& data, QObject* parent = nullptr);

  const std::vector<Alarm>& alarms() const { return alarms_; }
  /// The first that nobody has acknowledged; null when there is none.
  const Alarm* first() const;
  /// How long before `now` [s] it came, tick and cause.
  static QString text(const Alarm& alarm, double now);
  /// Playback: what lies behind the place where it stands is not shown.
  void refresh();

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation,
                      int role = Qt::DisplayRole) const override;

 Q_SIGNALS:
  void changed();

 private:
  void take(const RunEvent& event);
  void take_fault(const RunEvent& event);
  void acknowledge(const RunEvent& event);
  void refuse(const RunEvent& event);
  void clear();

  DataStore& store_;
  std::vector<Alarm> alarms_;
  std::size_t shown_ = 0;           // of the store's events
  std::int64_t refused_tick_ = -1;  // at which a device did not acknowledge
};

}  // namespace trocar::gui
