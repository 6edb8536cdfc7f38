// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/device_page.hpp"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "gui/graph/graph_reading.hpp"

namespace trocar::gui {

DevicePage::DevicePage(Operator& operators, QWidget* parent)
    : Page(parent),
      sources_(operators.sources()),
      picture_(new MechanismView(sources_, this)),
      joint_table_(new CellView("joint_table", "axes of the device", &joints_, this)),
      range_table_(new CellView("range_table", "ranges of the mechanism", &ranges_, this)),
      site_table_(new CellView("site_table", "sites, fixtures and forces", &sites_, this)) {
  setObjectName("device_page");
  build();
  // One graph for picture and tables: the operator is told of it wherever it comes from.
  connect(&operators, &Operator::named_changed, this, &DevicePage::read_graph);
  read_graph();
}

void DevicePage::build() {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  auto* left = new QVBoxLayout;
  left->addWidget(picture_, 1);
  auto* workspace = new QCheckBox("show where the tool reaches", this);
  workspace->setObjectName("workspace_shown");
  workspace->setAccessibleName("show where the tool reaches");
  connect(workspace, &QCheckBox::toggled, picture_, &MechanismView::set_workspace_shown);
  connect(picture_, &MechanismView::workspace_shown_changed, workspace, &QCheckBox::setChecked);
  left->addWidget(workspace);
  layout->addLayout(left, 4);
  auto* right = new QVBoxLayout;
  const auto add = [&](const char* title, CellView* table, int stretch) {
    auto* label = new QLabel(title, this);
    label->setBuddy(table);
    right->addWidget(label);
    right->addWidget(table, stretch);
  };
  add("<b>Axes</b>: position, velocity and effort", joint_table_, 8);
  add("<b>Ranges</b> of the mechanism", range_table_, 8);
  add("<b>Sites and fixtures</b>: position and force in the device's frame", site_table_, 9);
  layout->addLayout(right, 8);
}

void DevicePage::read_graph() {
  signals_ = JointSignals::of(graph_of(sources_));
  refresh();
}

void DevicePage::refresh() {
  picture_->refresh();
  const Scene& scene = picture_->scene();
  joints_.show(joint_rows(signals_, scene, sources_.data));
  ranges_.show(range_rows(scene, picture_->pose()));
  sites_.show(site_rows(scene, picture_->pose(), sources_.data));
}

void DevicePage::set_theme(const Theme& theme) {
  picture_->set_theme(theme);
  for (CellView* table : {joint_table_, range_table_, site_table_}) table->set_theme(theme);
}

}  // namespace trocar::gui
