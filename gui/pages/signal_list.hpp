// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTreeView>

#include "gui/analysis/signal_tree.hpp"

namespace trocar::gui {

/// All signals to choose from, with a search. They are dragged onto a plot, or chosen and added by
/// Enter.
class SignalList : public QWidget {
  Q_OBJECT

 public:
  explicit SignalList(DataStore& store, QWidget* parent = nullptr);

  QStringList chosen() const;  // signals at and below what is chosen
  void refresh();              // the values

 Q_SIGNALS:
  void wanted(const QStringList& names);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void search(const QString& text);

  SignalTree signals_;
  QSortFilterProxyModel found_;
  QLineEdit* search_;
  QTreeView* tree_;
};

}  // namespace trocar::gui
