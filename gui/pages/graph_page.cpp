// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/graph_page.hpp"

#include <QSplitter>
#include <QVBoxLayout>

namespace trocar::gui {

GraphPage::GraphPage(Operator& operators, QWidget* parent)
    : Page(parent),
      model_(operators.sources()),
      view_(new GraphView(model_, this)),
      name_(new QLabel(this)),
      state_(new QLabel(this)),
      legend_(new QLabel(this)),
      port_table_(new CellView("port_table", "ports of the chosen component", &ports_, this)) {
  setObjectName("graph_page");
  build();
  connect(view_, &GraphView::selected_changed, this, &GraphPage::show_ports);
  show_ports();
}

void GraphPage::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  auto* split = new QSplitter(Qt::Horizontal, this);
  split->setObjectName("graph_split");
  split->addWidget(view_);
  auto* side = new QWidget(split);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(4, 0, 0, 0);
  for (QLabel* label : {name_, state_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    column->addWidget(label);
  }
  QFont bold = name_->font();
  bold.setBold(true);
  name_->setFont(bold);
  name_->setObjectName("component_name");
  state_->setObjectName("component_state");
  column->addWidget(port_table_, 1);
  split->addWidget(side);
  split->setStretchFactor(0, 2);
  split->setStretchFactor(1, 1);
  split->setSizes({840, 420});
  layout->addWidget(split, 1);
  legend_->setObjectName("graph_legend");
  legend_->setWordWrap(true);
  legend_->setText(
      "Solid: read in the same tick. Dotted: a tick later. Dashed: by another thread, with the "
      "value's age. Double edge: a device. Times are of one tick of the component.");
  layout->addWidget(legend_);
}

void GraphPage::show_ports() {
  const auto node = view_->selected();
  if (!node) {
    name_->setText("no component is chosen");
    state_->clear();
    ports_.show({});
    return;
  }
  const GraphStructure::Node& one = model_.structure().nodes[*node];
  name_->setText(QString::fromStdString(one.name + ": " + one.doc));
  ports_.show(model_.port_rows(*node));
  port_table_->fit_columns();
  state_->setText(model_.description(*node));
}

void GraphPage::refresh() {
  model_.refresh();
  if (const auto node = view_->selected()) {
    ports_.show(model_.port_rows(*node));
    state_->setText(model_.description(*node));
  }
  view_->update();
}

void GraphPage::set_theme(const Theme& theme) {
  view_->set_theme(theme);
  port_table_->set_theme(theme);
}

}  // namespace trocar::gui
