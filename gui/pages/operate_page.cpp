// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/operate_page.hpp"

#include <QGridLayout>
#include <algorithm>

namespace trocar::gui {
namespace {

constexpr int most_parameters = 4;  // more have a page of their own

/// What an operator moves first: live numbers of the fixtures.
bool is_of_fixture(const ParameterView& view, const NamedSignals& named) {
  return view.live && view.is_number &&
         std::any_of(named.fixtures.begin(), named.fixtures.end(), [&](const auto& fixture) {
           return view.name.startsWith(QString::fromStdString(fixture.name + "."));
         });
}

}  // namespace

OperatePage::OperatePage(Operator& operators, QWidget* parent)
    : Page(parent),
      operator_(operators),
      meter_(new ForceMeter(this)),
      picture_(new MechanismView(operators.sources(), this)),
      force_(new TimePlot(operators.sources().data, this)),
      tip_(new TimePlot(operators.sources().data, this)),
      over_depth_(new XyPlot(operators.sources().data, this)) {
  setObjectName("operate_page");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 2, 4, 2);
  auto* middle = new QHBoxLayout;
  layout->addLayout(middle, 1);
  auto* left = new QVBoxLayout;
  left->addWidget(meter_);
  left->addWidget(picture_, 1);
  middle->addLayout(left, 2);
  auto* right = new QVBoxLayout;
  middle->addLayout(right, 5);
  force_->set_title("Force");
  tip_->set_title("Tip");
  over_depth_->set_title("Force over depth");
  force_->setObjectName("force_plot");
  tip_->setObjectName("tip_plot");
  over_depth_->setObjectName("over_depth_plot");
  right->addWidget(force_, 1);
  right->addWidget(tip_, 1);
  right->addWidget(over_depth_, 1);
  rows_ = new QVBoxLayout;
  rows_->setSpacing(0);
  layout->addLayout(rows_);
  connect(&operator_, &Operator::named_changed, this, [this] {
    choose_signals();
    choose_parameters();
  });
  connect(&operator_.parameters(), &ParameterModel::modelReset, this,
          &OperatePage::choose_parameters);
  choose_signals();
  choose_parameters();
}

void OperatePage::choose_signals() {
  const NamedSignals& named = operator_.named();
  force_->clear_curves();
  tip_->clear_curves();
  if (!named.wrench.empty())
    for (const char* axis : {".force.x", ".force.y", ".force.z"})
      force_->add_curve(named.wrench + axis);
  if (!named.scale.empty()) force_->set_saturation(named.scale);
  if (!named.tip.empty())
    for (const char* axis : {".x", ".y", ".z"}) tip_->add_curve(named.tip + axis);
  const auto fixture = std::find_if(named.fixtures.begin(), named.fixtures.end(),
                                    [](const auto& one) { return !one.depth.empty(); });
  if (fixture != named.fixtures.end())
    over_depth_->set_signals(fixture->depth, fixture->force + ".z");
  else if (!named.tip.empty() && !named.wrench.empty())
    over_depth_->set_signals(named.tip + ".z", named.wrench + ".force.z");
  cap_ = 0.0;
  show_cap();
}

void OperatePage::show_cap() {
  if (const double cap = operator_.named().force_cap; cap > 0 && cap != cap_) {
    cap_ = cap;
    force_->set_cap(cap);
    over_depth_->set_cap(cap);
  }
}

void OperatePage::choose_parameters() {
  QStringList names;
  for (const ParameterView& view : operator_.parameters().parameters())
    if (names.size() < most_parameters && is_of_fixture(view, operator_.named()))
      names << view.name;
  QStringList shown;
  for (const ParameterRow* row : parameters_) shown << row->name();
  if (names == shown) return;
  for (ParameterRow* row : parameters_) row->deleteLater();
  parameters_.clear();
  for (const QString& name : names) {
    parameters_.push_back(new ParameterRow(operator_.parameters(), name, this));
    parameters_.back()->set_theme(theme_);
    rows_->addWidget(parameters_.back());
  }
}

void OperatePage::refresh() {
  meter_->show_status(operator_.status(), theme_);
  picture_->refresh();
  show_cap();
  force_->refresh();
  tip_->refresh();
  over_depth_->refresh();
}

void OperatePage::set_theme(const Theme& theme) {
  theme_ = theme;
  picture_->set_theme(theme);
  force_->set_theme(theme);
  tip_->set_theme(theme);
  over_depth_->set_theme(theme);
  for (ParameterRow* row : parameters_) row->set_theme(theme);
}

void OperatePage::freeze(std::optional<double> at) {
  force_->freeze(at);
  tip_->freeze(at);
  over_depth_->freeze(at);
}

}  // namespace trocar::gui
