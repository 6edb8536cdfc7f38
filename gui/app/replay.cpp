// SPDX-License-Identifier: Apache-2.0
#include "gui/app/replay.hpp"

#include <QCryptographicHash>
#include <QFileInfo>

#include "gui/window/pages.hpp"

namespace trocar::gui {

namespace {

QString mark_of(const LogFeed::Script& script) {
  if (script.name.empty()) return "";
  const QByteArray hash =
      QCryptographicHash::hash(QByteArray::fromStdString(script.text), QCryptographicHash::Sha256);
  return "   " + Operator::mark_of(script.name, hash.toHex().toStdString());
}

}  // namespace

Replay::Replay(const std::string& path) {
  feed_.open(path);
  operator_ = std::make_unique<Operator>(Sources{.data = data_, .log = &feed_});
  operator_->set_graph(feed_.graph());
  connect(&feed_, &LogFeed::opened, operator_.get(),
          [this] { operator_->set_graph(feed_.graph()); });
  const QString name = QFileInfo(QString::fromStdString(path)).fileName();
  window_ = std::make_unique<MainWindow>(*operator_, name);
  window_->set_mark(name + mark_of(feed_.script()));
  add_pages(*window_, *operator_);
  auto* bar = new PlaybackBar(data_, feed_, clock_);
  connect(window_.get(), &MainWindow::theme_changed, bar, &PlaybackBar::set_theme);
  window_->add_bar(bar);
}

Replay::~Replay() = default;

}  // namespace trocar::gui
