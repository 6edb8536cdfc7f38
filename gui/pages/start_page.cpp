// SPDX-License-Identifier: Apache-2.0
#include "gui/pages/start_page.hpp"

#include <QCommandLinkButton>
#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QVBoxLayout>

namespace trocar::gui {
namespace {

constexpr int column_width = 620;  // [pixels]

}  // namespace

QString shipped_script(const QString& name) {
  const QDir program(QCoreApplication::applicationDirPath());
  for (const char* folder : {"../../scripts", "../share/trocar/scripts"}) {
    const QString file = program.filePath(QString(folder) + "/" + name);
    if (QFileInfo::exists(file)) return QDir::cleanPath(file);
  }
  return "";
}

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  setObjectName("start_page");
  auto* layout = new QVBoxLayout(this);
  layout->addStretch(1);
  auto* title =
      new QLabel("<h1>Trocar</h1><p>Nothing is open yet. What would you like to see?</p>");
  title->setFixedWidth(column_width);
  layout->addWidget(title, 0, Qt::AlignHCenter);
  const auto choice = [&](const char* name, const QString& text, const QString& more) {
    auto* button = new QCommandLinkButton(text, more, this);
    button->setObjectName(name);
    button->setAccessibleName(text);
    button->setFixedWidth(column_width);
    layout->addWidget(button, 0, Qt::AlignHCenter);
    return button;
  };
  auto* demo = choice("open_demo", "Open the demo",
                      "A simulated laparoscope that is pushed into a wall; no device is needed");
  auto* script = choice("open_script", "Open a script …", "Runs it, and ends it with this window");
  auto* connect_to = choice("connect", "Connect to a run …",
                            "That somebody started with: trocar run SCRIPT --serve");
  auto* log = choice("open_log", "Open a log …", "Plays back what was recorded");
  layout->addStretch(2);

  const QString file = shipped_script("tutorial/01_feel_a_wall.lua");
  demo->setEnabled(!file.isEmpty());
  connect(demo, &QPushButton::clicked, this, [this, file] { Q_EMIT script_chosen(file); });
  connect(script, &QPushButton::clicked, this, [this] {
    const QString chosen = QFileDialog::getOpenFileName(this, "Open a script", {}, "Lua (*.lua)");
    if (!chosen.isEmpty()) Q_EMIT script_chosen(chosen);
  });
  connect(connect_to, &QPushButton::clicked, this, [this] {
    const QString url = QInputDialog::getText(this, "Connect to a run", "Address",
                                              QLineEdit::Normal, "ws://127.0.0.1:8765");
    if (!url.isEmpty()) Q_EMIT address_chosen(url);
  });
  connect(log, &QPushButton::clicked, this, [this] {
    const QString chosen = QFileDialog::getOpenFileName(this, "Open a log", {}, "Logs (*.mcap)");
    if (!chosen.isEmpty()) Q_EMIT log_chosen(chosen);
  });
}

}  // namespace trocar::gui
