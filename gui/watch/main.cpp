// SPDX-License-Identifier: Apache-2.0
// What `trocar watch` runs, a program of its own so that `trocar` needs no Qt. Its options are
// those of `trocar watch`, which checks them.
#include <unistd.h>

#include <QCommandLineParser>
#include <QCoreApplication>
#include <csignal>
#include <cstdio>

#include "gui/watch/watcher.hpp"

namespace {

using namespace trocar::gui;

void leave(int signal) {
  restore_terminal();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void print_line(const std::string& line) {
  std::fputs((line + "\n").c_str(), stdout);
  std::fflush(stdout);
}

WatchOptions options_from(const QCommandLineParser& parser) {
  WatchOptions options;
  options.list = parser.isSet("list");
  options.stop = parser.isSet("stop");
  for (const QString& pattern : parser.values("signals"))
    options.patterns.push_back(pattern.toStdString());
  options.seconds = parser.value("for").toDouble();
  const bool screen = isatty(STDOUT_FILENO) != 0 && !options.list && !options.stop;
  options.form = parser.isSet("json") ? WatchOptions::Form::json
                 : screen             ? WatchOptions::Form::screen
                                      : WatchOptions::Form::lines;
  options.interval = options.form == WatchOptions::Form::screen ? 0.2 : 1.0;
  if (parser.isSet("interval")) options.interval = parser.value("interval").toDouble();
  return options;
}

void draw(const Watcher& watcher, const Terminal& terminal) {
  const std::string text =
      "\033[H" + screen_text(watcher.view(), terminal.width(), terminal.height()) + "\033[J";
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  QCoreApplication app(argc, argv);
  QCommandLineParser parser;
  for (const char* flag : {"json", "list", "stop"}) parser.addOption({flag, ""});
  for (const char* valued : {"signals", "interval", "for"}) parser.addOption({valued, "", valued});
  parser.process(app);

  const WatchOptions options = options_from(parser);
  Watcher watcher(options, print_line, [](const std::string& text) {
    std::fprintf(stderr, "trocar: %s\n", text.c_str());
  });
  QObject::connect(
      &watcher, &Watcher::done, &app, [](int status) { QCoreApplication::exit(status); },
      Qt::QueuedConnection);
  std::unique_ptr<Terminal> terminal;
  if (options.form == WatchOptions::Form::screen) {
    terminal = std::make_unique<Terminal>();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, leave);
    QObject::connect(terminal.get(), &Terminal::key, &watcher, &Watcher::key);
    QObject::connect(&watcher, &Watcher::changed, &watcher, [&] { draw(watcher, *terminal); });
  }
  watcher.open(QUrl(parser.positionalArguments().value(0)));
  return app.exec();
}
