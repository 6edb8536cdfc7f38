// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <QUndoStack>
#include <optional>
#include <vector>

#include "gui/window/page.hpp"

namespace trocar::gui {

/// A parameter as an operator sees it: numbers in the unit of its declaration.
struct ParameterView {
  QString name;  // "wall.stiffness"
  QString text;  // as a script would write it
  QString unit;  // that is shown, "N/mm"
  QString doc;
  QStringList choices;
  double scale = 1.0;  // SI for one of `unit`
  double value = 0.0, first = 0.0;
  double min = 0.0, max = 0.0;  // infinite where there is no bound
  bool is_number = false;       // one number: it can be moved
  bool live = false;            // it can be changed while it runs

  enum class Edit { none, asked, accepted, ramped, refused };
  Edit edit = Edit::none;
  double asked = 0.0;      // in `unit`
  std::int64_t tick = -1;  // from which the edit is ramped
  QString trouble;         // why it was refused

  bool changed() const { return is_number && value != first; }
  bool bounded() const;
  QString range_text() const;
  QString edit_text() const;  // "asked 3 N/mm", "ramped from tick 1200"
};

/// The parameters of what runs. An edit goes asked → accepted → ramped, each as the runtime says;
/// what it refuses goes back. Edits can be undone, which is an edit of its own.
class ParameterModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { name, value, unit, range, first, state, columns };
  static constexpr int live_role = Qt::UserRole;  // whether it can be changed while it runs

  explicit ParameterModel(const Sources& sources, QObject* parent = nullptr);

  const std::vector<ParameterView>& parameters() const { return parameters_; }
  std::optional<int> find(const QString& name) const;
  /// Only who may write can change anything; a second client without the token reads.
  bool may_write() const;
  QUndoStack& history() { return history_; }

  /// Asks for a value in the parameter's unit. Edits of one gesture, as a slider that is drawn, are
  /// undone together; 0 is a gesture of its own. @return why not, or ""
  QString ask(int row, double value, int gesture = 0);
  int begin_gesture() { return ++gestures_; }
  QString reset(int row) { return ask(row, parameters_[static_cast<std::size_t>(row)].first); }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation,
                      int role = Qt::DisplayRole) const override;

 private:
  friend class ParameterEdit;
  void load();
  void send(const QString& name, double value);
  void hear(const std::vector<stream::NamedValue>& values);
  void hear_event(const RunEvent& event);
  void hear_status(const stream::Status& status);
  void touch(int row);

  Sources sources_;
  std::vector<ParameterView> parameters_;
  QUndoStack history_;
  int gestures_ = 0;
};

}  // namespace trocar::gui
