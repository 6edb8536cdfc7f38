// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLineEdit>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>

#include "gui/operate/operator.hpp"

namespace trocar::gui {

/// Those whose names have the text, and of these only what can be changed, or all.
class ParameterFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void show_all(bool all);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  bool all_ = false;
};

/// All parameters: searched, edited in their units, undone.
class ParametersPage : public Page {
  Q_OBJECT

 public:
  explicit ParametersPage(Operator& operators, QWidget* parent = nullptr);

  QString title() const override { return "Parameters"; }
  QKeySequence shortcut() const override { return QKeySequence("Ctrl+3"); }
  void refresh() override;
  void set_theme(const Theme&) override {}

 private:
  Operator& operator_;
  ParameterFilter* filtered_;
  QTableView* table_;
  QPushButton *undo_, *redo_, *reset_;
};

}  // namespace trocar::gui
