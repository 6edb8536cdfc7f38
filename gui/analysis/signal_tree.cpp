// SPDX-License-Identifier: Apache-2.0
#include "gui/analysis/signal_tree.hpp"

#include <QMimeData>
#include <algorithm>

#include "gui/data/shown_number.hpp"

namespace trocar::gui {

SignalTree::SignalTree(DataStore& data, QObject* parent) : QStandardItemModel(parent), data_(data) {
  connect(&data_, &DataStore::run_began, this, &SignalTree::fill);
  fill();
}

QStandardItem* SignalTree::child(QStandardItem* parent, const QString& text) {
  for (int row = 0; row < parent->rowCount(); ++row)
    if (parent->child(row)->text() == text) return parent->child(row);
  auto* item = new QStandardItem(text);
  const QString above = parent->data(path_role).toString();
  item->setData(above.isEmpty() ? text : above + "." + text, path_role);
  auto* number = new QStandardItem;
  for (QStandardItem* one : {item, number})
    one->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
  number->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  parent->appendRow({item, number});
  return item;
}

void SignalTree::fill() {
  clear();
  count_ = 0;
  setHorizontalHeaderLabels({"signal", "now"});
  for (const auto& track : data_.tracks())
    for (std::size_t i = 0; i < track->signal_list().size(); ++i) {
      const SchemaSignal& signal = track->signal_list()[i];
      const auto found = data_.find(signal.name);
      // Threads have rows' heads of the same names; only one of them goes by it.
      if (!found || found->track != track.get() || found->index != i) continue;
      const QString whole = QString::fromStdString(signal.name);
      QStandardItem* item = invisibleRootItem();
      for (const QString& part : whole.split('.')) item = child(item, part);
      item->setData(whole, signal_role);
      ++count_;
      item->setToolTip(QString("%1 [%2], thread %3")
                           .arg(whole, QString::fromStdString(signal.unit),
                                QString::fromStdString(track->name())));
    }
  Q_EMIT filled();
}

QVariant SignalTree::data(const QModelIndex& index, int role) const {
  // Asked for only what is in sight, each time it is painted: nobody needs to be told of changes.
  if (role == Qt::DisplayRole && index.isValid() && index.column() == value) {
    const QString signal = index.siblingAtColumn(name).data(signal_role).toString();
    const auto found = signal.isEmpty() ? std::nullopt : data_.find(signal.toStdString());
    return found ? QVariant(shown_number(found->last(), found->info().unit)) : QVariant();
  }
  return QStandardItemModel::data(index, role);
}

QStringList SignalTree::signals_below(const QModelIndex& index) const {
  const QModelIndex first = index.siblingAtColumn(name);
  QStringList names;
  if (const QString own = first.data(signal_role).toString(); !own.isEmpty()) names << own;
  for (int row = 0; row < rowCount(first); ++row)
    names << signals_below(this->index(row, name, first));
  return names;
}

QStringList SignalTree::names_of(const QModelIndexList& indexes) const {
  QStringList names;
  for (const QModelIndex& index : indexes)
    if (index.column() == name) names << signals_below(index);
  names.removeDuplicates();
  return names;
}

QMimeData* SignalTree::mimeData(const QModelIndexList& indexes) const {
  const QStringList names = names_of(indexes);
  if (names.empty()) return nullptr;
  auto* mime = new QMimeData;
  mime->setData(mime_type, names.join('\n').toUtf8());
  mime->setText(names.join('\n'));
  return mime;
}

}  // namespace trocar::gui
