// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <limits>
#include <vector>

namespace trocar::gui {

/// A table of texts that is filled anew again and again. What has not changed is not told.
class CellTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Role {
    sort_role = Qt::UserRole,  // the number, where there is one, or the text
    share_role,                // where a bar is drawn: 0 at its low end, 1 at its high end
    warning_role,
  };
  struct Cell {
    QString text{};
    double number = std::numeric_limits<double>::quiet_NaN();  // to sort by
    double share = std::numeric_limits<double>::quiet_NaN();   // of a bar
    bool warning = false;
    bool operator==(const Cell& other) const;
  };
  using Row = std::vector<Cell>;

  explicit CellTable(QStringList header, QObject* parent = nullptr)
      : QAbstractTableModel(parent), header_(std::move(header)) {}

  /// @param rows as many cells in each as the header has
  void show(std::vector<Row> rows);
  const std::vector<Row>& rows() const { return rows_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation,
                      int role = Qt::DisplayRole) const override;

 private:
  QStringList header_;
  std::vector<Row> rows_;
};

}  // namespace trocar::gui
