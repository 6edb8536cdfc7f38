// SPDX-License-Identifier: Apache-2.0
#include "gui/window/main_window.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QMessageBox>
#include <QPainter>
#include <QShortcut>
#include <QVBoxLayout>

#include "gui/pages/alarms_page.hpp"
#include "gui/window/state_look.hpp"

namespace trocar::gui {
namespace {

constexpr int frame_interval_ms = 33;
constexpr int border = 4;  // [pixels]

}  // namespace

MainWindow::MainWindow(Operator& operators, const QString& subject)
    : operator_(operators),
      subject_(subject),
      state_(new StateStrip(operators, this)),
      tabs_(new QTabBar(this)),
      stack_(new QStackedWidget(this)),
      veil_(new StaleVeil(stack_)),
      mark_label_(new Readout("mark", "script and trial", this)),
      frozen_(new Readout("frozen", "pictures", this)),
      loop_(new LoopStrip(this)) {
  build();
  add_keys();
  qApp->installEventFilter(this);
  connect(tabs_, &QTabBar::currentChanged, stack_, &QStackedWidget::setCurrentIndex);
  connect(&operator_.sources().data, &DataStore::run_began, this, [this] { freeze({}); });
  connect(&timer_, &QTimer::timeout, this, &MainWindow::refresh);
  timer_.start(frame_interval_ms);
  set_theme(theme_);
}

void MainWindow::build() {
  auto* middle = new QWidget(this);
  setCentralWidget(middle);
  auto* layout = new QVBoxLayout(middle);
  layout->setContentsMargins(border, border, border, border);
  layout->setSpacing(0);
  tabs_->setObjectName("pages");
  tabs_->setAccessibleName("pages");
  tabs_->setExpanding(false);
  tabs_->setDocumentMode(true);
  tabs_->setDrawBase(false);
  layout->addWidget(state_);
  layout->addWidget(tabs_);
  layout->addWidget(stack_, 1);
  auto* bottom = new QHBoxLayout;
  bottom->setSpacing(0);
  bottom->addWidget(loop_, 1);
  bottom->addWidget(frozen_);
  bottom->addWidget(mark_label_);
  layout->addLayout(bottom);
  resize(1280, 720);
}

void MainWindow::add_keys() {
  keys_.emplace_back("F12", "STOP: ends the rendering, from everywhere");
  const auto click = [](QPushButton& button) { return [&button] { button.click(); }; };
  add_key(QKeySequence("Ctrl+E"), "engage", click(state_->engage_button()));
  add_key(QKeySequence("Ctrl+R"), "record, or end the recording", click(state_->record_button()));
  add_key(QKeySequence("Ctrl+K"), "acknowledge faults", click(state_->acknowledge_button()));
  add_key(QKeySequence("Ctrl+M"), "write a remark into the log", [this] {
    for (std::size_t i = 0; i < pages_.size(); ++i)
      if (auto* alarms = dynamic_cast<AlarmsPage*>(pages_[i])) {
        show_page(static_cast<int>(i));
        alarms->begin_remark();
      }
  });
  add_key(QKeySequence("F8"), "freeze the plots; the run and its recording go on",
          [this] { toggle_freeze(); });
  add_key(QKeySequence::Undo, "undo the last edit of a parameter",
          [this] { operator_.parameters().history().undo(); });
  add_key(QKeySequence::Redo, "and redo it", [this] { operator_.parameters().history().redo(); });
  add_key(QKeySequence("Ctrl+T"), "light or dark",
          [this] { set_theme(theme_.dark ? Theme::light() : Theme::dark_one()); });
  add_key(QKeySequence("F1"), "this sheet", [this] { show_shortcuts(); });
  add_key(QKeySequence("?"), "this sheet, where nothing is typed", [this] { show_shortcuts(); });
}

void MainWindow::add_key(const QKeySequence& key, const QString& what,
                         const std::function<void()>& act) {
  auto* shortcut = new QShortcut(key, this);
  shortcut->setObjectName("shortcut " + key.toString());
  connect(shortcut, &QShortcut::activated, this, act);
  keys_.emplace_back(key.toString(QKeySequence::NativeText), what);
}

void MainWindow::add_page(Page* page) {
  const int number = stack_->addWidget(page);
  tabs_->addTab(page->title());
  tabs_->setTabToolTip(number, page->shortcut().toString());
  pages_.push_back(page);
  page->set_theme(theme_);
  page->freeze(frozen_at_);
  connect(page, &Page::freeze_wanted, this, &MainWindow::freeze);
  add_key(page->shortcut(), page->title(), [this, number] { show_page(number); });
  veil_->raise();
}

void MainWindow::add_bar(QWidget* bar) {
  static_cast<QVBoxLayout*>(centralWidget()->layout())
      ->insertWidget(centralWidget()->layout()->indexOf(stack_) + 1, bar);
}

Page* MainWindow::page() const {
  return dynamic_cast<Page*>(stack_->currentWidget());
}

void MainWindow::show_page(int number) {
  tabs_->setCurrentIndex(number);
}

void MainWindow::set_theme(const Theme& theme) {
  theme_ = theme;
  qApp->setPalette(theme.palette());
  state_->set_theme(theme);
  veil_->set_theme(theme);
  mark_label_->paint_plain(theme_.muted);
  frozen_->paint_sign(theme_.warning, theme_.surface);
  for (Page* page : pages_) page->set_theme(theme);
  Q_EMIT theme_changed(theme);
  refresh();
}

void MainWindow::refresh() {
  operator_.refresh();
  state_->refresh();
  loop_->refresh(operator_.status(), theme_);
  veil_->setVisible(operator_.status().state == RunState::unknown);
  frozen_->setVisible(frozen());
  if (frozen())
    frozen_->show_text(QString("FROZEN, behind %1 s; the recording goes on")
                           .arg(operator_.sources().data.now() - *frozen_at_, 0, 'f', 1));
  refresh_marks();
  // Pictures wait for a stop, and not the other way round.
  if (operator_.stop_control().state() == StopControl::State::stopping) return;
  if (Page* shown = page(); shown != nullptr && isVisible()) shown->refresh();
}

void MainWindow::refresh_marks() {
  const QString trial = operator_.recording().trial();
  const QString script = mark_.isEmpty() ? operator_.mark() : mark_;
  QStringList marks;
  if (!script.isEmpty()) marks << script;
  if (!trial.isEmpty())
    marks << "trial " + trial + (operator_.recording().incomplete() ? " INCOMPLETE" : "");
  mark_label_->show_text(marks.join("   "));
  const QString title = QString("%1 – %2 – Trocar")
                            .arg(QString(to_string(operator_.status().mode)),
                                 marks.isEmpty() ? subject_ : marks.join(" – "));
  if (title == windowTitle()) return;
  setWindowTitle(title);
  update();  // the border
}

void MainWindow::toggle_freeze() {
  freeze(frozen() ? std::nullopt : std::optional<double>(operator_.sources().data.now()));
  refresh();
}

void MainWindow::freeze(std::optional<double> at) {
  frozen_at_ = at;
  for (Page* page : pages_) page->freeze(at);
}

void MainWindow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.window);
  const Mode mode = operator_.status().mode;
  painter.setPen(QPen(colour_of(mode, theme_), border, border_of(mode)));
  painter.drawRect(rect().adjusted(border / 2, border / 2, -border / 2, -border / 2));
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    // A log cannot be stopped, and its window takes the key from no other.
    if (key->key() == Qt::Key_F12 && operator_.sources().link != nullptr) {
      if (event->type() == QEvent::KeyPress && !key->isAutoRepeat())
        operator_.stop_control().stop();
      event->accept();
      return true;  // before whoever has the focus, and before any dialog
    }
  }
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::show_shortcuts() {
  QString text = "<table cellspacing='4'>";
  for (const auto& one : keys_)
    text += QString("<tr><td><b>%1</b></td><td>%2</td></tr>")
                .arg(one.first.toHtmlEscaped(), one.second.toHtmlEscaped());
  auto* sheet =
      new QMessageBox(QMessageBox::NoIcon, "Keys", text + "</table>", QMessageBox::Close, this);
  sheet->setObjectName("shortcut_sheet");
  sheet->setAccessibleName("keys");
  sheet->setAttribute(Qt::WA_DeleteOnClose);
  sheet->open();
}

}  // namespace trocar::gui
