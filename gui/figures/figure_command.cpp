// SPDX-License-Identifier: Apache-2.0
#include "gui/figures/figure_command.hpp"

#include <fmt/format.h>

#include <QApplication>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "framework/text.hpp"
#include "gui/figures/figure.hpp"

namespace trocar::gui {
namespace {

constexpr const char* group = "Figures";

const FigureKind& kind_called(const std::string& name) {
  std::vector<std::string> names;
  for (const FigureKind& kind : figure_kinds()) {
    if (kind.name == name) return kind;
    names.emplace_back(kind.name);
  }
  const std::string near = nearest(name, names);
  throw FigureError(fmt::format("there is no figure \"{}\"{}: there are {}", name,
                                near.empty() ? "" : ", did you mean \"" + near + "\"?",
                                join(names, ", ")));
}

RowFilter filter_of(const std::vector<std::string>& where) {
  RowFilter filter;
  for (const std::string& one : where) {
    const std::size_t equals = one.find('=');
    if (equals == std::string::npos || equals == 0)
      throw FigureError("--where takes KEY=VALUE, e.g. seed=2, and not \"" + one + "\"");
    filter[one.substr(0, equals)] = one.substr(equals + 1);
  }
  return filter;
}

std::string list_of_kinds() {
  std::string text = "KIND of --figure, and what writes IN:";
  for (const FigureKind& kind : figure_kinds())
    text += fmt::format("\n  {}: {}\n    {}", kind.name, kind.shows, kind.takes);
  return text;
}

/// A drawing is the same with a display and without.
class Platform {
 public:
  Platform() {
    if (QCoreApplication::instance() != nullptr) return;
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    application_ = std::make_unique<QApplication>(count_, arguments_);
  }

 private:
  char name_[16] = "trocar-figure";
  char* arguments_[2] = {name_, nullptr};
  int count_ = 1;
  std::unique_ptr<QApplication> application_;
};

}  // namespace

void FigureCommand::add_options(CLI::App& app) {
  app.add_option("--figure", what_, "Draw the figure of an experiment and exit, without a display")
      ->expected(3)
      ->type_name("KIND IN OUT.(png|pdf|svg)")
      ->group(group);
  app.add_option("--where", where_, "Of published rows only those with KEY=VALUE, e.g. seed=2")
      ->type_name("KEY=VALUE")
      ->group(group);
  app.add_option("--figure-run", run_, "Which run of a log (default: 1)")
      ->check(CLI::PositiveNumber)
      ->group(group);
  app.add_option("--figure-thread", thread_, "Which thread of a log (default: the first)")
      ->type_name("NAME")
      ->group(group);
  app.add_option("--quantity", quantity_, "Of a workspace's map (default: continuous_force_least)")
      ->type_name("COLUMN")
      ->group(group);
  const std::string before = app.get_footer();
  app.footer((before.empty() ? "" : before + "\n") + list_of_kinds());
}

int FigureCommand::draw() const {
  const FigureKind& kind = kind_called(what_[0]);
  const FigureOptions options{
      .where = filter_of(where_), .run = run_, .thread = thread_, .quantity = quantity_};
  const DrawnFigure figure = kind.draw(ResultFile(what_[1]), options);
  figure.sheet->save(QString::fromStdString(what_[2]));
  fmt::print("{}{}: {:g} × {:g} mm\n", figure.text, what_[2], FigureSheet::width_mm,
             figure.sheet->height_mm());
  return 0;
}

int FigureCommand::run() const {
  const Platform platform;
  try {
    return draw();
  } catch (const FigureError& error) {
    fmt::print(stderr, "trocar-dashboard: {}\n", error.what());
    return misused;
  } catch (const std::exception& error) {
    fmt::print(stderr, "trocar-dashboard: {}\n", error.what());
    return failed;
  }
}

}  // namespace trocar::gui
