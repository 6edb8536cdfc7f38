// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/signal_list.hpp"

#include <QHeaderView>
#include <QKeyEvent>
#include <QVBoxLayout>

namespace trocar::gui {
namespace {

constexpr int value_width = 84;
constexpr int few = 40;  // signals that are all shown at once

}  // namespace

SignalList::SignalList(DataStore& store, QWidget* parent)
    : QWidget(parent), signals_(store), search_(new QLineEdit(this)), tree_(new QTreeView(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  search_->setObjectName("signal_search");
  search_->setAccessibleName("search signals");
  search_->setPlaceholderText("search signals, e.g. wall.force");
  search_->setClearButtonEnabled(true);
  layout->addWidget(search_);
  found_.setSourceModel(&signals_);
  found_.setFilterRole(SignalTree::path_role);
  found_.setFilterCaseSensitivity(Qt::CaseInsensitive);
  found_.setRecursiveFilteringEnabled(true);
  found_.setAutoAcceptChildRows(true);
  tree_->setObjectName("signal_tree");
  tree_->setAccessibleName("signals");
  tree_->setModel(&found_);
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setDragEnabled(true);
  tree_->setUniformRowHeights(true);
  tree_->setTabKeyNavigation(false);
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setMinimumSectionSize(40);
  tree_->installEventFilter(this);
  layout->addWidget(tree_, 1);
  connect(search_, &QLineEdit::textChanged, this, &SignalList::search);
  const auto show = [this] {
    tree_->header()->setSectionResizeMode(SignalTree::name, QHeaderView::Stretch);
    tree_->header()->setSectionResizeMode(SignalTree::value, QHeaderView::Fixed);
    tree_->header()->resizeSection(SignalTree::value, value_width);
    if (signals_.count() <= few) tree_->expandAll();
  };
  connect(&signals_, &SignalTree::filled, this, show);
  show();
}

void SignalList::search(const QString& text) {
  found_.setFilterFixedString(text);
  text.isEmpty() ? tree_->collapseAll() : tree_->expandAll();
}

QStringList SignalList::chosen() const {
  QModelIndexList indexes;
  for (const QModelIndex& index : tree_->selectionModel()->selectedRows())
    indexes << found_.mapToSource(index);
  return signals_.names_of(indexes);
}

void SignalList::refresh() {
  tree_->viewport()->update();
}

bool SignalList::eventFilter(QObject*, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return false;
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key != Qt::Key_Return && key != Qt::Key_Enter) return false;
  if (const QStringList names = chosen(); !names.isEmpty()) Q_EMIT wanted(names);
  return true;
}

}  // namespace trocar::gui
