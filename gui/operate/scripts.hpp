// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gui/window/page.hpp"

namespace trocar::gui {

/// A component whose law is a script of its own.
struct LawScript {
  QString component;
  QString file;  // name; its path once it was reloaded
  QString verdict;
  double time = 0.0;         // [s] of a step, the last
  double worst_time = 0.0;   // [s] of what is in the store
  double allocations = 0.0;  // of a step, the last
  double memory = 0.0;       // [B]
};

/// The laws in Lua that run, what they cost, and what became of reloading them.
class ScriptModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { component, file, time, worst_time, allocations, memory, verdict, columns };

  explicit ScriptModel(const Sources& sources, QObject* parent = nullptr);

  const std::vector<LawScript>& scripts() const { return scripts_; }
  void set_graph(const nlohmann::json& graph);
  /// Reads the newest costs.
  void refresh();
  /// The law anew from its file; its verdict comes later.
  void reload(int row);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation,
                      int role = Qt::DisplayRole) const override;

 private:
  void hear_event(const RunEvent& event);
  void judge(const QString& component, const QString& verdict);
  void take_file(const QString& component, const QString& path);
  void change(const QString& component, const std::function<void(LawScript&)>& edit);

  Sources sources_;
  std::vector<LawScript> scripts_;
};

}  // namespace trocar::gui
