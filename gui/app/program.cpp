// SPDX-License-Identifier: Apache-2.0
#include "gui/app/program.hpp"

#include <fmt/format.h>

#include <QFileInfo>
#include <QMessageBox>
#include <QTimer>

#include "framework/text.hpp"
#include "gui/pages/plots_page.hpp"
#include "gui/window/pages.hpp"

namespace trocar::gui {
namespace {

std::vector<std::string> titles_of(const MainWindow& window) {
  std::vector<std::string> titles;
  for (const Page* page : window.pages()) titles.push_back(page->title().toStdString());
  return titles;
}

/// Below 0: there is none.
int page_called(const MainWindow& window, const std::string& name) {
  const std::vector<std::string> titles = titles_of(window);
  const QString wanted = QString::fromStdString(name);
  for (std::size_t i = 0; i < titles.size(); ++i)
    if (name == std::to_string(i + 1) ||
        QString::fromStdString(titles[i]).startsWith(wanted, Qt::CaseInsensitive))
      return static_cast<int>(i);
  return -1;
}

}  // namespace

int Program::exec() {
  if (options_.list_pages) return list_pages();
  const bool chosen =
      !options_.script.empty() || !options_.connect.empty() || !options_.log.empty();
  if (!chosen)
    ask();
  else if (const int status = show_subject(); status != 0)
    return status;
  return QApplication::exec();
}

int Program::show_subject() {
  if (!options_.log.empty()) {
    try {
      replay_ = std::make_unique<Replay>(options_.log);
    } catch (const std::exception& error) {
      fmt::print(stderr, "trocar-dashboard: {}\n", error.what());
      if (start_) QMessageBox::warning(start_.get(), "Open a log", error.what());
      return 1;
    }
    replay_->clock().seek(options_.at);
    return show(replay_->window());
  }
  dashboard_ = std::make_unique<Dashboard>();
  QStringList runtime;
  for (const std::string& one : options_.runtime) runtime << QString::fromStdString(one);
  if (!options_.script.empty())
    dashboard_->run(QFileInfo(QString::fromStdString(options_.script)).absoluteFilePath(), runtime);
  else
    dashboard_->attach(QUrl(QString::fromStdString(options_.connect)));
  return show(dashboard_->window());
}

int Program::show(MainWindow& window) {
  if (!options_.layout.empty() && !load_layout(window)) return 2;
  const int page = page_called(window, options_.page);
  if (page < 0) {
    fmt::print(stderr, "trocar-dashboard: there is no page \"{}\": there are {}\n", options_.page,
               join(titles_of(window), ", "));
    return 2;
  }
  window.resize(options_.window_size());
  window.set_theme(options_.window_theme());
  window.show_page(page);
  window.show();
  if (options_.screenshot.empty()) return 0;
  QTimer::singleShot(static_cast<int>(1000 * options_.after), &window, [this, &window] {
    window.refresh();
    take_picture(window);
  });
  return 0;
}

bool Program::load_layout(MainWindow& window) {
  auto* plots = window.findChild<PlotsPage*>();
  try {
    plots->load_layout(QString::fromStdString(options_.layout));
  } catch (const std::exception& error) {
    fmt::print(stderr, "trocar-dashboard: {}\n", error.what());
    return false;
  }
  if (options_.page == DashboardOptions().page) options_.page = plots->title().toStdString();
  return true;
}

int Program::list_pages() {
  DataStore data;
  Operator operators(Sources{data});
  MainWindow window(operators, "");
  add_pages(window, operators);
  for (const std::string& title : titles_of(window)) fmt::print("{}\n", title);
  return 0;
}

void Program::ask() {
  qApp->setPalette(options_.window_theme().palette());
  start_ = std::make_unique<StartPage>();
  start_->setWindowTitle("Trocar");
  start_->resize(options_.window_size());
  const auto connect = [this](auto chosen, std::string DashboardOptions::*subject) {
    QObject::connect(start_.get(), chosen, start_.get(),
                     [this, subject](const QString& what) { choose(subject, what); });
  };
  connect(&StartPage::script_chosen, &DashboardOptions::script);
  connect(&StartPage::address_chosen, &DashboardOptions::connect);
  connect(&StartPage::log_chosen, &DashboardOptions::log);
  start_->show();
  if (!options_.screenshot.empty())
    QTimer::singleShot(0, start_.get(), [this] { take_picture(*start_); });
}

void Program::choose(std::string DashboardOptions::*subject, const QString& chosen) {
  options_.*subject = chosen.toStdString();
  try {
    if (!options_.connect.empty()) options_.connect = stream_address(options_.connect);
  } catch (const CLI::ValidationError& error) {
    QMessageBox::warning(start_.get(), "Connect to a run", error.what());
    return (options_.*subject).clear();
  }
  if (show_subject() == 0)
    start_->hide();
  else
    (options_.*subject).clear();
}

void Program::take_picture(QWidget& window) {
  const bool written = window.grab().save(QString::fromStdString(options_.screenshot));
  if (!written) fmt::print(stderr, "trocar-dashboard: {} cannot be written\n", options_.screenshot);
  QApplication::exit(written ? 0 : 1);
}

}  // namespace trocar::gui
