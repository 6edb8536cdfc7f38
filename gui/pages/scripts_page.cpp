// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/scripts_page.hpp"

#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

namespace trocar::gui {

ScriptsPage::ScriptsPage(Operator& operators, QWidget* parent)
    : Page(parent),
      operator_(operators),
      scripts_(operators.sources()),
      table_(new QTableView(this)),
      reload_(new QPushButton("Reload from its file", this)),
      verdict_(new QPlainTextEdit(this)) {
  setObjectName("scripts_page");
  build();
  connect(&operator_, &Operator::named_changed, this,
          [this] { scripts_.set_graph(operator_.graph()); });
  scripts_.set_graph(operator_.graph());
  connect(reload_, &QPushButton::clicked, this, [this] { scripts_.reload(row()); });
}

void ScriptsPage::build() {
  auto* layout = new QVBoxLayout(this);
  auto* head = new QLabel(
      "<b>Laws in Lua</b>. Edit a file, then reload it: the new version is tried beside the old "
      "one, "
      "and takes over within 0.2 s or is refused.",
      this);
  head->setWordWrap(true);
  layout->addWidget(head);
  table_->setModel(&scripts_);
  table_->setObjectName("script_table");
  table_->setAccessibleName("laws in Lua");
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setAlternatingRowColors(true);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setColumnWidth(ScriptModel::component, 160);
  table_->setColumnWidth(ScriptModel::file, 260);
  layout->addWidget(table_, 2);
  reload_->setObjectName("reload");
  reload_->setAccessibleName("reload the law from its file");
  layout->addWidget(reload_, 0, Qt::AlignLeft);
  verdict_->setObjectName("verdict");
  verdict_->setAccessibleName("what came of reloading");
  verdict_->setReadOnly(true);
  verdict_->setTabChangesFocus(true);
  verdict_->setPlaceholderText("what came of reloading the law that is chosen");
  layout->addWidget(verdict_, 1);
}

int ScriptsPage::row() const {
  const QModelIndex chosen = table_->currentIndex();
  if (chosen.isValid()) return chosen.row();
  return scripts_.rowCount() == 1 ? 0 : -1;
}

void ScriptsPage::refresh() {
  scripts_.refresh();
  const StreamClient* link = operator_.sources().link;
  reload_->setEnabled(row() >= 0 && link != nullptr && link->state() == LinkState::open &&
                      link->may_write());
  const QString said = scripts_.rowCount() == 0
                           ? QString("no component of this graph has a law in Lua")
                       : row() < 0 ? QString()
                                   : scripts_.scripts()[static_cast<std::size_t>(row())].verdict;
  if (said != verdict_->toPlainText()) verdict_->setPlainText(said);
}

}  // namespace trocar::gui
