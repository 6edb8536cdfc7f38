// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStyledItemDelegate>
#include <QTableView>
#include <QTimer>

#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// Draws cells of a CellTable that have a share as a bar with a mark, and warnings in bold: what
/// the text says is not told by colour alone.
class CellDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  explicit CellDelegate(QObject* parent) : QStyledItemDelegate(parent) {}
  void set_theme(const Theme& theme) { theme_ = theme; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;

 private:
  Theme theme_ = Theme::light();
};

/// A table to read, by rows.
class CellView : public QTableView {
  Q_OBJECT

 public:
  /// @param accessible what it is a table of
  CellView(const char* name, const QString& accessible, QAbstractItemModel* model, QWidget* parent);
  void set_theme(const Theme& theme);
  /// Columns as wide as what is in them, within reason.
  void fit_columns();
  /// The same, but none narrower than it was: numbers that change do not make it twitch.
  void widen_columns();

 private:
  int width_for(int column) const;

  CellDelegate* delegate_;
  QTimer widen_;  // soon after what is shown has changed
};

}  // namespace trocar::gui
