// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <QSize>
#include <string>
#include <vector>

#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// What `trocar-dashboard` was started with.
struct DashboardOptions {
  std::string script, connect, log;  // at most one of them
  std::vector<std::string> runtime;  // options of `trocar run`
  std::string theme = "light";
  std::string size = "1280x720";
  std::string screenshot;
  double after = 5.0;      // [s] until the screenshot
  double at = 0.0;         // [s] in the log
  std::string page = "1";  // its number, or how its title begins
  std::string layout{};    // file, of the page of plots
  bool list_pages = false;

  QSize window_size() const;  // [pixels]
  Theme window_theme() const { return theme == "dark" ? Theme::dark_one() : Theme::light(); }
};

void add_options(CLI::App& app, DashboardOptions& options);

/// "lab:8765" is ws://lab:8765. @throw CLI::ValidationError when it is no address of a stream
std::string stream_address(const std::string& text);

}  // namespace trocar::gui
