// SPDX-License-Identifier: Apache-2.0
#include "gui/data/cell_table.hpp"

#include <cmath>

namespace trocar::gui {
namespace {

bool same_number(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

bool CellTable::Cell::operator==(const Cell& other) const {
  return text == other.text && same_number(number, other.number) &&
         same_number(share, other.share) && warning == other.warning;
}

void CellTable::show(std::vector<Row> rows) {
  if (rows.size() != rows_.size()) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
    return;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] == rows_[i]) continue;
    rows_[i] = std::move(rows[i]);
    const int row = static_cast<int>(i);
    Q_EMIT dataChanged(index(row, 0), index(row, static_cast<int>(header_.size()) - 1));
  }
}

int CellTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int CellTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(header_.size());
}

QVariant CellTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const auto column = static_cast<std::size_t>(index.column());
  if (column >= row.size()) return {};
  const Cell& cell = row[column];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
      return cell.text;
    case sort_role:
      return std::isnan(cell.number) ? QVariant(cell.text) : QVariant(cell.number);
    case share_role:
      return std::isnan(cell.share) ? QVariant() : QVariant(cell.share);
    case warning_role:
      return cell.warning;
    case Qt::TextAlignmentRole:
      return std::isnan(cell.number) ? QVariant::fromValue(Qt::AlignLeft | Qt::AlignVCenter)
                                     : QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant CellTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole || section < 0 ||
      section >= header_.size())
    return {};
  return header_[section];
}

}  // namespace trocar::gui
