// SPDX-License-Identifier: Apache-2.0
#include "gui/app/replay.hpp"

#include <QFileInfo>

#include "gui/window/pages.hpp"

namespace trocar::gui {

Replay::Replay(const std::string& path) {
  feed_.open(path);
  operator_ = std::make_unique<Operator>(Sources{.data = data_, .log = &feed_});
  operator_->set_graph(feed_.graph());
  connect(&feed_, &LogFeed::opened, operator_.get(),
          [this] { operator_->set_graph(feed_.graph()); });
  const QString name = QFileInfo(QString::fromStdString(path)).fileName();
  window_ = std::make_unique<MainWindow>(*operator_, name);
  window_->set_mark(name);
  add_pages(*window_, *operator_);
  auto* bar = new PlaybackBar(data_, feed_, clock_);
  connect(window_.get(), &MainWindow::theme_changed, bar, &PlaybackBar::set_theme);
  window_->add_bar(bar);
}

Replay::~Replay() = default;

}  // namespace trocar::gui
