// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/parameters_page.hpp"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

namespace trocar::gui {
namespace {

QPushButton* page_button(const char* name, const QString& text, QWidget* parent) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setAccessibleName(text);
  return made;
}

}  // namespace

void ParameterFilter::show_all(bool all) {
  all_ = all;
  invalidateFilter();
}

bool ParameterFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const bool live = sourceModel()->index(row, 0, parent).data(ParameterModel::live_role).toBool();
  return (all_ || live) && QSortFilterProxyModel::filterAcceptsRow(row, parent);
}

ParametersPage::ParametersPage(Operator& operators, QWidget* parent)
    : Page(parent),
      operator_(operators),
      filtered_(new ParameterFilter(this)),
      table_(new QTableView(this)),
      undo_(page_button("undo", "Undo  Ctrl+Z", this)),
      redo_(page_button("redo", "Redo  Ctrl+Shift+Z", this)),
      reset_(page_button("reset", "Back to what it was at first", this)) {
  setObjectName("parameters_page");
  auto* layout = new QVBoxLayout(this);
  auto* head = new QHBoxLayout;
  layout->addLayout(head);
  auto* search = new QLineEdit(this);
  search->setObjectName("parameter_search");
  search->setAccessibleName("search parameters");
  search->setPlaceholderText("search, e.g. stiffness");
  search->setClearButtonEnabled(true);
  head->addWidget(search, 1);
  auto* all = new QCheckBox("also what is fixed while it runs", this);
  all->setObjectName("all_parameters");
  all->setAccessibleName(all->text());
  head->addWidget(all);
  connect(all, &QCheckBox::toggled, filtered_, &ParameterFilter::show_all);
  for (QPushButton* each : {undo_, redo_, reset_}) head->addWidget(each);
  filtered_->setSourceModel(&operator_.parameters());
  filtered_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  table_->setModel(filtered_);
  table_->setObjectName("parameter_table");
  table_->setAccessibleName("parameters");
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setAlternatingRowColors(true);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  layout->addWidget(table_, 1);
  connect(search, &QLineEdit::textChanged, filtered_, &QSortFilterProxyModel::setFilterFixedString);
  QUndoStack& history = operator_.parameters().history();
  connect(undo_, &QPushButton::clicked, &history, &QUndoStack::undo);
  connect(redo_, &QPushButton::clicked, &history, &QUndoStack::redo);
  connect(reset_, &QPushButton::clicked, this, [this] {
    const QModelIndex at = filtered_->mapToSource(table_->currentIndex());
    if (!at.isValid()) return;
    const QString trouble = operator_.parameters().reset(at.row());
    if (!trouble.isEmpty()) Q_EMIT operator_.remark(trouble);
  });
}

void ParametersPage::refresh() {
  const ParameterModel& model = operator_.parameters();
  QUndoStack& history = operator_.parameters().history();
  undo_->setEnabled(history.canUndo() && model.may_write());
  redo_->setEnabled(history.canRedo() && model.may_write());
  reset_->setEnabled(table_->currentIndex().isValid() && model.may_write());
}

}  // namespace trocar::gui
