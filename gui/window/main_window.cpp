// SPDX-License-Identifier: Apache-2.0
#include "gui/window/main_window.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QMessageBox>
#include <QPainter>
#include <QShortcut>
#include <QVBoxLayout>

namespace trocar::gui {
namespace {

constexpr int frame_interval_ms = 33;
constexpr int border = 4;  // [pixels]

}  // namespace

MainWindow::MainWindow(Operator& operators, const QString& subject)
    : operator_(operators), subject_(subject) {
  auto* middle = new QWidget(this);
  setCentralWidget(middle);
  auto* layout = new QVBoxLayout(middle);
  layout->setContentsMargins(border, border, border, border);
  layout->setSpacing(0);
  state_ = new StateStrip(operators, this);
  tabs_ = new QTabBar(this);
  tabs_->setObjectName("pages");
  tabs_->setAccessibleName("pages");
  tabs_->setExpanding(false);
  tabs_->setDocumentMode(true);
  stack_ = new QStackedWidget(this);
  loop_ = new LoopStrip(this);
  mark_label_ = new QLabel(this);
  mark_label_->setObjectName("mark");
  mark_label_->setAccessibleName("script and trial");
  layout->addWidget(state_);
  layout->addWidget(tabs_);
  layout->addWidget(stack_, 1);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(loop_, 1);
  bottom->addWidget(mark_label_);
  layout->addLayout(bottom);
  resize(1280, 720);
  connect(tabs_, &QTabBar::currentChanged, stack_, &QStackedWidget::setCurrentIndex);

  add_key(QKeySequence("F1"), "this sheet", [this] { show_shortcuts(); });
  add_key(QKeySequence("Ctrl+T"), "light or dark",
          [this] { set_theme(theme_.dark ? Theme::light() : Theme::dark_one()); });
  const auto press = [this](const char* name) {
    return [this, name] { state_->findChild<QPushButton*>(name)->click(); };
  };
  add_key(QKeySequence("Ctrl+E"), "engage", press("engage"));
  add_key(QKeySequence("Ctrl+R"), "record, or end the recording", press("record"));
  add_key(QKeySequence("Ctrl+K"), "acknowledge faults", press("acknowledge"));
  add_key(QKeySequence::Undo, "undo the last edit of a parameter",
          [this] { operator_.parameters().history().undo(); });
  add_key(QKeySequence::Redo, "and redo it", [this] { operator_.parameters().history().redo(); });
  keys_.insert(keys_.begin(), {"F12", "STOP: ends the rendering, from everywhere"});
  qApp->installEventFilter(this);
  connect(&timer_, &QTimer::timeout, this, &MainWindow::refresh);
  timer_.start(frame_interval_ms);
  set_theme(theme_);
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
  add_key(page->shortcut(), page->title(), [this, number] { show_page(number); });
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
  mark_label_->setStyleSheet(QString("color:%1; padding:3px 8px;").arg(theme.muted.name()));
  for (Page* page : pages_) page->set_theme(theme);
  Q_EMIT theme_changed(theme);
  refresh();
}

void MainWindow::set_mark(const QString& mark) {
  mark_ = mark;
}

void MainWindow::refresh() {
  operator_.refresh();
  state_->refresh();
  loop_->refresh(operator_.status(), theme_);
  const QString trial = operator_.recording().trial();
  const QString mark =
      mark_ + (trial.isEmpty() ? "" : (mark_.isEmpty() ? "trial " : "   trial ") + trial);
  if (mark != mark_label_->text()) mark_label_->setText(mark);
  const QString title =
      QString("%1 – %2 – Trocar").arg(QString(to_string(operator_.status().mode)), subject_);
  if (title != windowTitle()) {
    setWindowTitle(title);
    update();  // the border
  }
  if (Page* shown = page(); shown != nullptr && isVisible()) shown->refresh();
}

void MainWindow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.window);
  const Mode mode = operator_.status().mode;
  const QColor colour = mode == Mode::live        ? theme_.live
                        : mode == Mode::simulated ? theme_.simulated
                        : mode == Mode::replay    ? theme_.replay
                                                  : theme_.muted;
  // Not by colour alone: each has a pattern of its own.
  painter.setPen(QPen(colour, border,
                      mode == Mode::live        ? Qt::SolidLine
                      : mode == Mode::simulated ? Qt::DashLine
                                                : Qt::DotLine));
  painter.drawRect(rect().adjusted(border / 2, border / 2, -border / 2, -border / 2));
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_F12) {
      if (event->type() == QEvent::KeyPress && !key->isAutoRepeat())
        operator_.stop_control().stop();
      event->accept();
      return true;  // before whoever has the focus, and before any dialog
    }
  }
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::show_shortcuts() {
  QString text = "<table cellspacing='6'>";
  for (const auto& one : keys_)
    text += QString("<tr><td><b>%1</b></td><td>%2</td></tr>")
                .arg(one.first.toHtmlEscaped(), one.second.toHtmlEscaped());
  auto* sheet =
      new QMessageBox(QMessageBox::NoIcon, "Keys", text + "</table>", QMessageBox::Close, this);
  sheet->setObjectName("shortcut_sheet");
  sheet->setAttribute(Qt::WA_DeleteOnClose);
  sheet->open();
}

}  // namespace trocar::gui
