// SPDX-License-Identifier: Apache-2.0
// The operator's dashboard. As a program it is under the GPL-3 of QCustomPlot, which it links.
#include <QApplication>
#include <cstdio>

#include "gui/app/options.hpp"
#include "gui/app/program.hpp"
#include "gui/figures/figure_command.hpp"

namespace {

/// Qt would abort without one.
bool has_display() {
  for (const char* name : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"})
    if (!qEnvironmentVariableIsEmpty(name)) return true;
  return false;
}

/// Qt's platform without a display complains of what no picture needs.
void say(QtMsgType, const QMessageLogContext&, const QString& message) {
  if (!message.contains("propagateSizeHints") && !message.contains("XDG_RUNTIME_DIR"))
    std::fprintf(stderr, "%s\n", qPrintable(message));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App parser("Watch a run, move its parameters, and stop it.", "trocar-dashboard");
  trocar::gui::DashboardOptions options;
  trocar::gui::FigureCommand figure;
  figure.add_options(parser);
  add_options(parser, options);
  try {
    parser.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parser.exit(error) == 0 ? 0 : 2;
  }
  if (figure.is_asked_for()) return figure.run();
  if (!options.screenshot.empty() || options.list_pages) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler(say);
  }
  if (!has_display()) {
    std::fputs(
        "trocar-dashboard: there is no display. --screenshot FILE.png needs none, and `trocar "
        "watch` "
        "follows a run on a terminal\n",
        stderr);
    return 2;
  }
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);  // they would keep F12 from us
  const QApplication app(argc, argv);
  QApplication::setApplicationName("trocar-dashboard");
  QApplication::setStyle("Fusion");  // the same everywhere, and it takes all colours of a palette
  return trocar::gui::Program(options).exec();
}
