// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/timing_page.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QVBoxLayout>

namespace trocar::gui {
namespace {

constexpr int worst_column = 4;  // of a component

}  // namespace

TimingPage::TimingPage(Operator& operators, QWidget* parent)
    : Page(parent),
      model_(operators.sources()),
      notice_(new QLabel(this)),
      thread_table_(new CellView("thread_times", "times of the threads", &threads_, this)),
      component_table_(new CellView("component_times", "times of the components", &sorted_, this)),
      histogram_(new HistogramPlot(model_, this)),
      margin_(new MarginPlot(operators.sources().data, model_, this)) {
  setObjectName("timing_page");
  sorted_.setSortRole(CellTable::sort_role);
  sorted_.setSourceModel(&components_);
  build();
  connect(&model_, &TimingModel::threads_changed, this, [this] {
    show_numbers();
    shown_.invalidate();  // the next rows are shown at once
  });
  show_numbers();
  shown_.invalidate();
}

void TimingPage::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  auto* head = new QHBoxLayout;
  notice_->setObjectName("timing_notice");
  notice_->setWordWrap(true);
  head->addWidget(notice_, 1);
  auto* again = new QPushButton("Count from now", this);
  again->setObjectName("count_from_now");
  again->setAccessibleName("count from now");
  connect(again, &QPushButton::clicked, this, [this] {
    model_.forget();
    show_numbers();
  });
  head->addWidget(again);
  layout->addLayout(head);
  const int rows = 4;  // threads without scrolling
  thread_table_->setFixedHeight((rows + 1) * (fontMetrics().height() + 8));
  layout->addWidget(thread_table_);
  auto* plots = new QHBoxLayout;
  plots->addWidget(histogram_, 1);
  plots->addWidget(margin_, 1);
  layout->addLayout(plots, 3);
  component_table_->setSortingEnabled(true);
  component_table_->sortByColumn(worst_column, Qt::DescendingOrder);
  layout->addWidget(component_table_, 2);
}

void TimingPage::show_numbers() {
  threads_.show(model_.thread_rows());
  components_.show(model_.component_rows());
  thread_table_->widen_columns();
  component_table_->widen_columns();
  const QString notice = model_.notice();
  notice_->setText(notice.isEmpty() ? "Of all rows that this window has seen of the run." : notice);
  shown_.start();
}

void TimingPage::refresh() {
  const bool complete = model_.refresh();
  if (complete && shown_.isValid() && shown_.elapsed() < show_every_ms) return;
  show_numbers();
  histogram_->refresh();
  margin_->refresh();
}

void TimingPage::set_theme(const Theme& theme) {
  for (CellView* table : {thread_table_, component_table_}) table->set_theme(theme);
  histogram_->set_theme(theme);
  margin_->set_theme(theme);
}

}  // namespace trocar::gui
