// SPDX-License-Identifier: Apache-2.0
// The operator's dashboard. As a program it is under the GPL-3 of QCustomPlot, which it links.
#include <QApplication>

#include "gui/app/options.hpp"
#include "gui/app/program.hpp"
#include "gui/figures/figure_command.hpp"

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
  if (!options.screenshot.empty()) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);  // they would keep F12 from us
  const QApplication app(argc, argv);
  QApplication::setApplicationName("trocar-dashboard");
  QApplication::setStyle("Fusion");  // the same everywhere, and it takes all colours of a palette
  return trocar::gui::Program(options).exec();
}
