// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "gui/data/cell_table.hpp"
#include "gui/timing/thread_timing.hpp"
#include "gui/window/page.hpp"

namespace trocar::gui {

/// How punctual all threads of a run are, as of the rows that are shown.
class TimingModel : public QObject {
  Q_OBJECT

 public:
  static constexpr std::uint64_t rows_of_a_slice = 20'000;

  explicit TimingModel(const Sources& sources, QObject* parent = nullptr);

  /// Takes rows, some at each call. @return whether all are taken
  bool refresh();
  /// Counts from here on.
  void forget();
  const std::vector<std::unique_ptr<ThreadTiming>>& threads() const { return threads_; }
  /// What to know before the numbers are read: virtual time, no rows. "" where there is nothing.
  QString notice() const;

  static QStringList thread_header();
  std::vector<CellTable::Row> thread_rows() const;
  static QStringList component_header();
  std::vector<CellTable::Row> component_rows() const;

 Q_SIGNALS:
  void threads_changed();

 private:
  void read_tracks();
  bool virtual_time() const;

  Sources sources_;
  std::vector<std::unique_ptr<ThreadTiming>> threads_;
  bool behind_ = false;
};

}  // namespace trocar::gui
