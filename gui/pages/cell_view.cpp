// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/cell_view.hpp"

#include <QHeaderView>
#include <QPainter>
#include <algorithm>

#include "gui/data/cell_table.hpp"

namespace trocar::gui {

void CellDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  QStyleOptionViewItem shown = option;
  const bool warning = index.data(CellTable::warning_role).toBool();
  if (warning) {
    shown.font.setBold(true);
    shown.palette.setColor(QPalette::Text, theme_.warning);
  }
  const QVariant share = index.data(CellTable::share_role);
  if (!share.isValid()) {
    QStyledItemDelegate::paint(painter, shown, index);
    return;
  }
  initStyleOption(&shown, index);
  painter->save();
  const bool selected = (option.state & QStyle::State_Selected) != 0;
  painter->fillRect(option.rect, selected ? option.palette.highlight().color() : theme_.surface);
  const QRect text = option.rect.adjusted(4, -1, -4, -6);
  painter->setFont(shown.font);
  painter->setPen(selected  ? option.palette.highlightedText().color()
                  : warning ? theme_.warning
                            : theme_.text);
  painter->drawText(text, Qt::AlignCenter,
                    painter->fontMetrics().elidedText(shown.text, Qt::ElideRight, text.width()));
  const QRectF bar(option.rect.left() + 6, option.rect.bottom() - 6, option.rect.width() - 12, 3);
  painter->fillRect(bar, theme_.grid);
  const double at = bar.left() + bar.width() * std::clamp(share.toDouble(), 0.0, 1.0);
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(Qt::NoPen);
  painter->setBrush(warning ? theme_.warning : theme_.accent);
  painter->drawEllipse(QPointF(at, bar.center().y()), 4, 4);
  painter->restore();
}

CellView::CellView(const char* name, const QString& accessible, QAbstractItemModel* model,
                   QWidget* parent)
    : QTableView(parent), delegate_(new CellDelegate(this)) {
  setObjectName(name);
  setAccessibleName(accessible);
  setModel(model);
  setItemDelegate(delegate_);
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setWordWrap(false);
  setTabKeyNavigation(false);  // Tab leaves the table
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  horizontalHeader()->setHighlightSections(false);
  connect(model, &QAbstractItemModel::modelReset, this, &CellView::fit_columns);
  widen_.setSingleShot(true);
  widen_.setInterval(200);
  connect(&widen_, &QTimer::timeout, this, &CellView::widen_columns);
  connect(model, &QAbstractItemModel::dataChanged, this, [this] {
    if (!widen_.isActive()) widen_.start();
  });
  fit_columns();
}

void CellView::set_theme(const Theme& theme) {
  delegate_->set_theme(theme);
  viewport()->update();
}

int CellView::width_for(int column) const {
  constexpr int widest = 300;  // the rest is cut, and in the tooltip
  return std::max(std::min(sizeHintForColumn(column) + 8, widest),
                  horizontalHeader()->sectionSizeHint(column));
}

void CellView::fit_columns() {
  for (int column = 0; column < model()->columnCount(); ++column)
    setColumnWidth(column, width_for(column));
}

void CellView::widen_columns() {
  for (int column = 0; column < model()->columnCount(); ++column)
    setColumnWidth(column, std::max(columnWidth(column), width_for(column)));
}

}  // namespace trocar::gui
