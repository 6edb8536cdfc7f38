// SPDX-License-Identifier: Apache-2.0
#include "gui/app/options.hpp"

#include <QUrl>
#include <cstdio>

#include "framework/version.hpp"

namespace trocar::gui {
namespace {

constexpr QSize least_size(640, 480), greatest_size(8192, 8192);  // [pixels]

QSize size_of(const std::string& text) {
  int width = 0, height = 0;
  char rest = 0;
  return std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2 ? QSize(width, height)
                                                                           : QSize();
}

std::string check_size(const std::string& text) {
  const QSize size = size_of(text);
  const bool fits = size.expandedTo(least_size) == size && size.boundedTo(greatest_size) == size;
  return fits ? "" : "\"" + text + "\" is no size: 1280x720 is one, 640x480 the least";
}

void add_subjects(CLI::App& app, DashboardOptions& options) {
  auto* script = app.add_option("script", options.script, "Script to run; it ends with the window")
                     ->type_name("FILE.lua")
                     ->check(CLI::ExistingFile);
  app.add_option("options", options.runtime, "After --: options of `trocar run`")
      ->type_name("OPTION ...")
      ->needs(script);
  app.add_option("--connect", options.connect, "Attach to a run that is served instead")
      ->type_name("URL")
      ->transform([](const std::string& text) { return stream_address(text); }, "")
      ->excludes(script);
  auto* open = app.add_option("--open", options.log, "Play a log instead")
                   ->type_name("LOG.mcap")
                   ->check(CLI::ExistingFile)
                   ->excludes(script)
                   ->excludes("--connect");
  app.add_option("--at", options.at, "Where to stand in the log at first [s]")->needs(open);
}

}  // namespace

std::string stream_address(const std::string& text) {
  const QString given = QString::fromStdString(text);
  const QUrl url(given.contains("://") ? given : "ws://" + given, QUrl::StrictMode);
  const bool fits =
      url.isValid() && !url.host().isEmpty() && (url.scheme() == "ws" || url.scheme() == "wss");
  if (!fits)
    throw CLI::ValidationError("\"" + text +
                               "\" is no address of a stream: ws://127.0.0.1:8765 is one");
  return url.toString().toStdString();
}

QSize DashboardOptions::window_size() const {
  return size_of(size);
}

void add_options(CLI::App& app, DashboardOptions& options) {
  add_subjects(app, options);
  app.add_option("--theme", options.theme, "light or dark")
      ->check(CLI::IsMember({"light", "dark"}))
      ->capture_default_str();
  app.add_option("--page", options.page, "Page to begin with: its number, or how its title begins")
      ->capture_default_str();
  app.add_option("--layout", options.layout, "Show these plots, a layout that was saved")
      ->type_name("FILE.json")
      ->check(CLI::ExistingFile);
  app.add_flag("--list-pages", options.list_pages, "Print the pages' titles and leave");
  app.add_option("--size", options.size, "Of the window [pixels]")
      ->type_name("WxH")
      ->capture_default_str()
      ->check(check_size, "");
  auto* screenshot = app.add_option("--screenshot", options.screenshot,
                                    "Write a picture of the window, without a display, and leave")
                         ->type_name("FILE.png");
  app.add_option("--after", options.after, "Time until the picture [s]")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str()
      ->needs(screenshot);
  app.set_version_flag("--version", std::string("trocar-dashboard ") + version());
  app.footer(
      app.get_footer() +
      "\nExamples:\n  trocar-dashboard scripts/tutorial/01_feel_a_wall.lua\n"
      "  trocar-dashboard trial.lua -- --record trial_7.mcap --for 60s\n"
      "  trocar-dashboard --connect ws://lab:8765/?token=…\n"
      "  trocar-dashboard --open trial_7.mcap --at 12.5 --layout contact.json\n"
      "F12 stops the rendering, F1 shows all keys. This program is under the GPL, version 3.");
}

}  // namespace trocar::gui
