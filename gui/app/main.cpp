// SPDX-License-Identifier: Apache-2.0
// The operator's dashboard. As a program it is under the GPL-3 of QCustomPlot, which it links.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <memory>

#include "framework/text.hpp"
#include "framework/version.hpp"
#include "gui/app/dashboard.hpp"
#include "gui/app/replay.hpp"
#include "gui/figures/figure_command.hpp"
#include "gui/pages/start_page.hpp"
#include "gui/window/pages.hpp"

namespace {

using namespace trocar::gui;

struct DashboardOptions {
  std::string script, connect, log, theme = "light", screenshot, size = "1280x720";
  std::vector<std::string> runtime;
  double after = 5.0;
  double at = 0.0;
  std::string page = "1";
  bool list_pages = false;
};

void add_options(CLI::App& app, DashboardOptions& options) {
  app.add_option("script", options.script, "Script to run; it ends with the window")
      ->type_name("FILE.lua")
      ->check(CLI::ExistingFile);
  app.add_option("--connect", options.connect, "Attach to a run that is served instead")
      ->type_name("URL")
      ->excludes("script");
  auto* open = app.add_option("--open", options.log, "Play a log instead")
                   ->type_name("LOG.mcap")
                   ->check(CLI::ExistingFile)
                   ->excludes("script")
                   ->excludes("--connect");
  app.add_option("--at", options.at, "Where to stand in the log at first [s]")->needs(open);
  app.add_option("--theme", options.theme, "light or dark")
      ->check(CLI::IsMember({"light", "dark"}))
      ->capture_default_str();
  app.add_option("--page", options.page, "Page to begin with: its number, or how its title begins")
      ->capture_default_str();
  app.add_flag("--list-pages", options.list_pages, "Print the pages' titles and leave");
  auto* screenshot = app.add_option("--screenshot", options.screenshot,
                                    "Write a picture of the window, without a display, and leave")
                         ->type_name("FILE.png");
  app.add_option("--size", options.size, "Of the window [pixels]")
      ->type_name("WxH")
      ->capture_default_str()
      ->check(CLI::Validator(
          [](const std::string& text) {
            int width = 0, height = 0;
            char rest = 0;
            return std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2 &&
                           width >= 320 && height >= 240 && width <= 8192 && height <= 8192
                       ? std::string()
                       : "\"" + text + "\" is no size: 1280x720 is one, 320x240 the least";
          },
          "WxH"));
  app.add_option("--after", options.after, "Time until the picture [s]")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str()
      ->needs(screenshot);
  app.add_option("--run", options.runtime,
                 "Options of `trocar run`, each after a --run, e.g. --run=--record=trial.mcap")
      ->type_name("OPTION")
      ->needs("script");
  app.set_version_flag("--version", std::string("trocar-dashboard ") + trocar::version());
  app.footer(
      "Examples:\n  trocar-dashboard scripts/tutorial/01_feel_a_wall.lua\n"
      "  trocar-dashboard --connect ws://lab:8765/?token=…\n"
      "  trocar-dashboard --open trial.mcap --at 12.5\n"
      "F12 stops the rendering, F1 shows all keys. This program is under the GPL, version 3.");
}

QSize size_of(const std::string& text) {
  int width = 1280, height = 720;
  std::sscanf(text.c_str(), "%dx%d", &width, &height);
  return {width, height};
}

std::vector<std::string> titles_of(const MainWindow& window) {
  std::vector<std::string> titles;
  for (const Page* page : window.pages()) titles.push_back(page->title().toStdString());
  return titles;
}

/// @throw std::invalid_argument where there is no such page
int page_called(const MainWindow& window, const std::string& name) {
  const std::vector<std::string> titles = titles_of(window);
  const QString wanted = QString::fromStdString(name);
  for (std::size_t i = 0; i < titles.size(); ++i)
    if (name == std::to_string(i + 1) ||
        QString::fromStdString(titles[i]).startsWith(wanted, Qt::CaseInsensitive))
      return static_cast<int>(i);
  throw std::invalid_argument("there is no page \"" + name + "\": there are " +
                              trocar::join(titles, ", "));
}

void show(MainWindow& window, const DashboardOptions& options) {
  window.resize(size_of(options.size));
  window.set_theme(options.theme == "dark" ? Theme::dark_one() : Theme::light());
  window.show_page(page_called(window, options.page));
  window.show();
  if (options.screenshot.empty()) return;
  QTimer::singleShot(static_cast<int>(1000 * options.after), &window, [&window, &options] {
    window.refresh();
    const bool written = window.grab().save(QString::fromStdString(options.screenshot));
    if (!written)
      fmt::print(stderr, "trocar-dashboard: {} cannot be written\n", options.screenshot);
    QApplication::exit(written ? 0 : 1);
  });
}

void open(Dashboard& dashboard, const DashboardOptions& options) {
  QStringList runtime;
  for (const std::string& one : options.runtime) runtime << QString::fromStdString(one);
  if (!options.script.empty())
    dashboard.run(QFileInfo(QString::fromStdString(options.script)).absoluteFilePath(), runtime);
  else
    dashboard.attach(QUrl(QString::fromStdString(options.connect)));
  show(dashboard.window(), options);
}

/// A start page that becomes a dashboard once somebody chose.
int choose(QApplication& app, DashboardOptions& options) {
  app.setPalette((options.theme == "dark" ? Theme::dark_one() : Theme::light()).palette());
  std::unique_ptr<Dashboard> dashboard;
  StartPage start;
  start.setWindowTitle("Trocar");
  start.resize(size_of(options.size));
  const auto become = [&] {
    dashboard = std::make_unique<Dashboard>();
    open(*dashboard, options);
    start.hide();
  };
  QObject::connect(&start, &StartPage::script_chosen, [&](const QString& file) {
    options.script = file.toStdString();
    become();
  });
  QObject::connect(&start, &StartPage::address_chosen, [&](const QString& url) {
    options.connect = url.toStdString();
    become();
  });
  start.show();
  if (!options.screenshot.empty()) {
    const bool written = start.grab().save(QString::fromStdString(options.screenshot));
    return written ? 0 : 1;
  }
  return app.exec();
}

int play(const DashboardOptions& options) {
  Replay replay(options.log);
  replay.clock().seek(options.at);
  show(replay.window(), options);
  return QApplication::exec();
}

int watch(const DashboardOptions& options) {
  Dashboard dashboard;
  open(dashboard, options);
  return QApplication::exec();
}

int list_pages() {
  DataStore data;
  Operator operators(Sources{data});
  MainWindow window(operators, "");
  add_pages(window, operators);
  for (const std::string& title : titles_of(window)) fmt::print("{}\n", title);
  return 0;
}

int begin(QApplication& app, DashboardOptions& options) {
  if (options.list_pages) return list_pages();
  if (!options.log.empty()) return play(options);
  if (options.script.empty() && options.connect.empty()) return choose(app, options);
  return watch(options);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App parser("Watch a run, move its parameters, and stop it.", "trocar-dashboard");
  DashboardOptions options;
  FigureCommand figure;
  add_options(parser, options);
  figure.add_options(parser);
  try {
    parser.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int status = parser.exit(error);
    return status == 0 ? 0 : 2;
  }
  if (figure.is_asked_for()) return figure.run();
  if (!options.screenshot.empty() || options.list_pages) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);  // they would keep F12 from us
  QApplication app(argc, argv);
  app.setApplicationName("trocar-dashboard");
  app.setStyle("Fusion");  // the same everywhere, and it takes all colours of a palette
  try {
    return begin(app, options);
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "trocar-dashboard: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "trocar-dashboard: {}\n", error.what());
    return 1;
  }
}
