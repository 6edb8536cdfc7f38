// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/plots_page.hpp"

#include <QFileDialog>
#include <QInputDialog>
#include <QMenu>
#include <QRegularExpression>
#include <QShortcut>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/analysis/visible_csv.hpp"

namespace trocar::gui {
namespace {

constexpr double near_now = 1e-3;  // of the span: is the right end
constexpr int scrub_steps = 10'000;
constexpr int table_rows = 5;  // without scrolling

QPushButton* page_button(const char* name, const QString& text, const QString& what,
                         QWidget* parent) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setAccessibleName(what);
  made->setToolTip(what);
  return made;
}

QCheckBox* page_box(const char* name, const QString& text, const QString& what, QWidget* parent) {
  auto* made = new QCheckBox(text, parent);
  made->setObjectName(name);
  made->setAccessibleName(what);
  made->setToolTip(what);
  return made;
}

/// [s] of the oldest row of all.
double oldest(const DataStore& data) {
  double time = data.now();
  for (const auto& track : data.tracks())
    if (!track->empty()) time = std::min(time, track->time(track->first()));
  return time;
}

}  // namespace

PlotsPage::PlotsPage(Operator& operators, QWidget* parent)
    : Page(parent),
      operator_(operators),
      data_(operators.sources().data),
      list_(new SignalList(data_, this)),
      board_(new PlotBoard(data_, this)),
      span_(new QDoubleSpinBox(this)),
      cursors_box_(page_box("cursors", "Cursors", "two cursors, A and B", this)),
      events_box_(page_box("events", "Events", "marks of faults, remarks and refusals", this)),
      trigger_box_(page_box("trigger", "Trigger", "pictures about a trigger", this)),
      difference_(new QLabel(this)),
      notice_(new QLabel(this)),
      trigger_bar_(new TriggerBar(data_, this)),
      scrub_(new QSlider(Qt::Horizontal, this)),
      where_(new QLabel(this)),
      values_(new CellView("value_table", "values of the signals", &table_, this)) {
  setObjectName("plots_page");
  build();
  connect_all();
  show_layout({.plots = {{}}});
  is_chosen_ = false;
  choose_signals();
}

void PlotsPage::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 2, 4, 2);
  layout->setSpacing(3);
  auto* sides = new QSplitter(Qt::Horizontal, this);
  sides->setObjectName("plots_sides");
  list_->setMinimumWidth(200);
  sides->addWidget(list_);
  auto* right = new QWidget(sides);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(3);
  column->addWidget(make_head());
  column->addWidget(trigger_bar_);
  auto* rows = new QSplitter(Qt::Vertical, right);
  rows->setObjectName("plots_rows");
  auto* pictures = new QWidget(rows);
  auto* under = new QVBoxLayout(pictures);
  under->setContentsMargins(0, 0, 0, 0);
  under->setSpacing(2);
  under->addWidget(board_, 1);
  under->addLayout(make_scrub());
  rows->addWidget(pictures);
  rows->addWidget(values_);
  rows->setStretchFactor(0, 1);
  rows->setSizes({1000, (table_rows + 1) * (fontMetrics().height() + 7)});
  column->addWidget(rows, 1);
  sides->addWidget(right);
  sides->setStretchFactor(1, 1);
  sides->setSizes({250, 1000});
  layout->addWidget(sides, 1);
}

QWidget* PlotsPage::make_head() {
  auto* head = new QWidget(this);
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  auto* add = page_button("add_plot", "New plot", "another plot, of the chosen signals", head);
  auto* xy =
      page_button("add_xy", "X–Y", "a plot of the second chosen signal over the first", head);
  auto* remove = page_button("remove_plot", "Remove", "remove the plot that is framed", head);
  connect(add, &QPushButton::clicked, this, [this] {
    is_chosen_ = true;
    board_->add_plot({});
    board_->add_signals(list_->chosen());
  });
  connect(xy, &QPushButton::clicked, this, &PlotsPage::add_xy);
  connect(remove, &QPushButton::clicked, this, [this] {
    is_chosen_ = true;
    board_->remove_chosen();
  });
  auto* title = page_button("plot_title", "Title", "name the plot that is framed", head);
  connect(title, &QPushButton::clicked, this, &PlotsPage::ask_title);
  for (QPushButton* button : {add, xy, remove, title}) {
    button->setMaximumWidth(fontMetrics().horizontalAdvance(button->text()) + 24);
    row->addWidget(button);
  }
  span_->setObjectName("span");
  span_->setAccessibleName("time that is shown");
  span_->setToolTip("time that is shown");
  span_->setRange(least_span, greatest_span);
  span_->setSuffix(" s");
  span_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  span_->setKeyboardTracking(false);
  row->addWidget(span_);
  for (QWidget* box : {cursors_box_, events_box_, trigger_box_}) row->addWidget(box);
  difference_->setObjectName("cursor_difference");
  row->addWidget(difference_);
  notice_->setObjectName("plots_notice");
  notice_->setMinimumWidth(1);
  notice_->setTextFormat(Qt::PlainText);
  notice_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(notice_, 1);
  row->addWidget(make_menu("layout_menu", "Layout",
                           {{"Save…",
                             [this] {
                               ask_file("Save the layout", "Layouts (*.json)", true,
                                        [this](const QString& path) {
                                          write_layout_file(path, layout_shown());
                                        });
                             }},
                            {"Load…", [this] {
                               ask_file("Load a layout", "Layouts (*.json)", false,
                                        [this](const QString& path) { load_layout(path); });
                             }}}));
  row->addWidget(make_menu("export_menu", "Export",
                           {{"Table of what is visible…",
                             [this] {
                               ask_file("Write what is visible", "Tables (*.csv)", true,
                                        [this](const QString& path) { export_table(path); });
                             }},
                            {"Picture…", [this] {
                               ask_file("Write a picture", "Pictures (*.png *.svg *.pdf)", true,
                                        [this](const QString& path) { export_picture(path); });
                             }}}));
  return head;
}

QWidget* PlotsPage::make_menu(
    const char* name, const QString& text,
    const std::vector<std::pair<QString, std::function<void()>>>& entries) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setAccessibleName(text);
  button->setText(text + " ");
  button->setPopupMode(QToolButton::InstantPopup);
  button->setFocusPolicy(Qt::StrongFocus);
  auto* menu = new QMenu(button);
  for (const auto& [what, act] : entries) connect(menu->addAction(what), &QAction::triggered, act);
  button->setMenu(menu);
  return button;
}

QHBoxLayout* PlotsPage::make_scrub() {
  auto* row = new QHBoxLayout;
  scrub_->setObjectName("scrub");
  scrub_->setAccessibleName("time that is looked at");
  scrub_->setToolTip("time that is looked at; its right end follows the run");
  scrub_->setRange(0, scrub_steps);
  scrub_->setValue(scrub_steps);
  row->addWidget(scrub_, 1);
  where_->setObjectName("scrub_place");
  where_->setMinimumWidth(fontMetrics().horizontalAdvance("up to 0000.00 s, frozen"));
  row->addWidget(where_);
  return row;
}

void PlotsPage::connect_all() {
  connect(list_, &SignalList::wanted, this, [this](const QStringList& names) {
    is_chosen_ = true;
    board_->add_signals(names);
  });
  connect(board_, &PlotBoard::plots_changed, this, [this] {
    trigger_bar_->show_names(board_->signal_names());
    if (trigger_bar_->settings().signal != trigger_.settings().signal) take_trigger();
    show_level();
    shown_.invalidate();
  });
  connect(board_, &PlotBoard::scrubbed, this, &PlotsPage::scrub);
  connect(board_, &PlotBoard::zoomed, this, &PlotsPage::zoom);
  connect(board_, &PlotBoard::cursor_moved, this, &PlotsPage::move_cursor);
  connect(span_, &QDoubleSpinBox::valueChanged, this, [this](double span) {
    if (!showing_) look_at(window_shown().end, span);
  });
  connect(cursors_box_, &QCheckBox::toggled, this, [this](bool on) {
    if (showing_) return;
    const TimeWindow window = window_shown();
    const double middle = window.begin - window.zero, span = window.end - window.begin;
    set_cursors(on ? std::optional<Cursors>({middle + 0.4 * span, middle + 0.6 * span})
                   : std::nullopt);
  });
  connect(events_box_, &QCheckBox::toggled, board_, &PlotBoard::set_events_shown);
  connect(trigger_box_, &QCheckBox::toggled, this, &PlotsPage::take_trigger);
  connect(trigger_bar_, &TriggerBar::changed, this, &PlotsPage::take_trigger);
  connect(trigger_bar_, &TriggerBar::arm, this, [this] {
    if (view_.frozen) Q_EMIT freeze_wanted({});
    take_trigger();
  });
  connect(scrub_, &QSlider::valueChanged, this, [this](int value) {
    if (showing_) return;
    const double from = oldest(data_), to = data_.now();
    look_at(value == scrub_steps ? to : from + (to - from) * value / scrub_steps, view_.span);
  });
  auto* remove = new QShortcut(QKeySequence::Delete, values_);
  remove->setObjectName("shortcut remove curve");
  remove->setContext(Qt::WidgetShortcut);
  connect(remove, &QShortcut::activated, this, &PlotsPage::remove_row);
  connect(&operator_, &Operator::named_changed, this, &PlotsPage::choose_signals);
}

/// At first what the graph names: force and tip.
void PlotsPage::choose_signals() {
  const NamedSignals& named = operator_.named();
  if (is_chosen_ || (named.wrench.empty() && named.tip.empty())) return;
  PlotLayout layout;
  const auto plot = [&](const char* title, const std::string& of) {
    if (!of.empty())
      layout.plots.push_back({.title = title, .names = {of + ".x", of + ".y", of + ".z"}});
  };
  plot("Force", named.wrench.empty() ? "" : named.wrench + ".force");
  plot("Tip", named.tip);
  show_layout(layout);
  is_chosen_ = false;
}

void PlotsPage::show_layout(const PlotLayout& layout) {
  is_chosen_ = true;
  showing_ = true;
  view_.span = layout.span;
  span_->setValue(layout.span);
  events_box_->setChecked(layout.events);
  board_->set_events_shown(layout.events);
  board_->show_plots(layout.plots);
  trigger_box_->setChecked(layout.trigger.has_value());
  if (layout.trigger) trigger_bar_->show_settings(*layout.trigger);
  showing_ = false;
  set_cursors(layout.cursors);
  if (cursors_) {
    const TimeWindow window = window_shown();
    for (double& at : *cursors_)
      at = std::clamp(at, window.begin - window.zero, window.end - window.zero);
    set_cursors(cursors_);
  }
  take_trigger();
}

PlotLayout PlotsPage::layout_shown() const {
  PlotLayout layout{.span = view_.span, .events = events_box_->isChecked(), .cursors = cursors_};
  if (trigger_box_->isChecked()) layout.trigger = trigger_bar_->settings();
  layout.plots = board_->plots();
  return layout;
}

TimeWindow PlotsPage::window_shown() const {
  return view_.at(data_.now());
}

void PlotsPage::add_xy() {
  const QStringList names = list_->chosen();
  if (names.size() != 2)
    return notice_->setText(QString("X–Y takes two signals, x first: %1 %2 chosen at the left")
                                .arg(names.size())
                                .arg(names.size() == 1 ? "is" : "are"));
  is_chosen_ = true;
  board_->add_plot({.kind = PlotDescription::Kind::xy,
                    .names = {names[0].toStdString(), names[1].toStdString()}});
}

void PlotsPage::scrub(double seconds) {
  look_at(window_shown().end + seconds, view_.span);
}

void PlotsPage::zoom(double factor) {
  const TimeWindow window = window_shown();
  look_at(window.end, factor * (window.end - window.begin));
}

/// The run and its recording go on; at its newest row the picture follows again.
void PlotsPage::look_at(double end, double span) {
  const TimeWindow before = window_shown();
  if (view_.shot) {
    trigger_.disarm();
    view_.shot.reset();
  }
  view_.span = std::clamp(span, least_span, greatest_span);
  const double now = data_.now();
  const bool follows = end >= now - near_now * view_.span;
  view_.frozen = follows ? std::nullopt : std::optional(std::max(end, oldest(data_)));
  Q_EMIT freeze_wanted(view_.frozen);
  // The cursors stay at the rows that they were at.
  if (cursors_ && !follows) {
    const double shift = before.zero - window_shown().zero;
    set_cursors(Cursors{(*cursors_)[0] + shift, (*cursors_)[1] + shift});
  }
  show_view();
}

void PlotsPage::freeze(std::optional<double> at) {
  view_.frozen = at;
  show_view();
}

void PlotsPage::set_cursors(const std::optional<Cursors>& cursors) {
  cursors_ = cursors;
  showing_ = true;
  cursors_box_->setChecked(cursors.has_value());
  showing_ = false;
  board_->set_cursors(cursors);
  difference_->setText(cursors ? ValueTable::difference_text(*cursors) : QString());
  shown_.invalidate();
}

void PlotsPage::move_cursor(int which, double at) {
  if (!cursors_) return;
  Cursors moved = *cursors_;
  moved[static_cast<std::size_t>(which)] = at;
  set_cursors(moved);
}

void PlotsPage::take_trigger() {
  if (showing_) return;
  trigger_bar_->setVisible(trigger_box_->isChecked());
  const TriggerSettings settings = trigger_bar_->settings();
  if (trigger_box_->isChecked() && !settings.signal.empty())
    trigger_.arm(data_, settings);
  else
    trigger_.disarm();
  show_level();
  follow_trigger();
}

void PlotsPage::show_level() {
  const bool off = trigger_.state() == Trigger::State::off;
  const TriggerSettings& settings = trigger_.settings();
  board_->set_level(settings.signal, off ? std::nullopt : std::optional(settings.level));
}

void PlotsPage::follow_trigger() {
  if (!view_.frozen) trigger_.search(data_);
  trigger_bar_->show_state(trigger_);
  if (view_.shot == trigger_.shot()) return;
  view_.shot = trigger_.shot();
  show_view();
}

void PlotsPage::show_view() {
  board_->set_view(view_);
  showing_ = true;
  span_->setValue(view_.span);
  showing_ = false;
  shown_.invalidate();
}

void PlotsPage::show_scrub() {
  const double from = oldest(data_), to = data_.now(), end = window_shown().end;
  const bool follows = !view_.frozen && !view_.shot;
  const double share = follows || to <= from ? 1.0 : (end - from) / (to - from);
  showing_ = true;
  if (!scrub_->isSliderDown())
    scrub_->setValue(static_cast<int>(std::lround(scrub_steps * std::clamp(share, 0.0, 1.0))));
  showing_ = false;
  where_->setText(QString("up to %1 s%2")
                      .arg(end, 0, 'f', 2)
                      .arg(view_.shot     ? ", triggered"
                           : view_.frozen ? ", frozen"
                                          : ""));
}

void PlotsPage::show_values() {
  value_rows_.fill(data_, board_->plots(), window_shown(), cursors_);
  table_.show(value_rows_.rows());
  values_->widen_columns();
  list_->refresh();
  shown_.start();
}

void PlotsPage::remove_row() {
  const auto row = static_cast<std::size_t>(values_->currentIndex().row());
  if (row >= value_rows_.sources().size()) return;
  is_chosen_ = true;
  const ValueTable::Source source = value_rows_.sources()[row];
  board_->remove_signal(static_cast<int>(source.plot), source.signal);
}

void PlotsPage::refresh() {
  follow_trigger();
  show_scrub();
  board_->refresh();
  if (!shown_.isValid() || shown_.elapsed() >= show_every_ms) show_values();
}

void PlotsPage::set_theme(const Theme& theme) {
  board_->set_theme(theme);
  values_->set_theme(theme);
}

void PlotsPage::ask_title() {
  if (board_->chosen() < 0) return;
  auto* dialog = new QInputDialog(this);
  dialog->setObjectName("title_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle("Title");
  dialog->setLabelText("Title of the plot that is framed");
  const auto chosen = static_cast<std::size_t>(board_->chosen());
  dialog->setTextValue(QString::fromStdString(board_->plots()[chosen].title));
  connect(dialog, &QInputDialog::textValueSelected, board_, &PlotBoard::set_title);
  dialog->open();
}

void PlotsPage::export_table(const QString& path) {
  const TimeWindow window = window_shown();
  write_csv(path, data_, board_->signal_names(), window.begin, window.end);
}

void PlotsPage::export_picture(const QString& path) {
  board_->save(path);
}

void PlotsPage::ask_file(const QString& what, const QString& filter, bool save,
                         const std::function<void(const QString&)>& act) {
  auto* dialog = new QFileDialog(this, what, QString(), filter);
  dialog->setObjectName("file_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(save ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
  dialog->setFileMode(save ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
  // The first ending of the filter, for a name without one.
  dialog->setDefaultSuffix(filter.section("*.", 1, 1).section(QRegularExpression("[ )]"), 0, 0));
  connect(dialog, &QFileDialog::fileSelected, this, [this, save, act](const QString& path) {
    try {
      act(path);
      notice_->setText((save ? "written: " : "loaded: ") + QFileInfo(path).fileName());
    } catch (const std::exception& error) {
      notice_->setText(error.what());
    }
    notice_->setToolTip(notice_->text());
  });
  dialog->open();
}

}  // namespace trocar::gui
