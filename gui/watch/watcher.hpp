// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gui/link/stop_check.hpp"
#include "gui/link/stream_client.hpp"
#include "gui/watch/terminal.hpp"
#include "gui/watch/watch_text.hpp"

namespace trocar::gui {

struct WatchOptions {
  enum class Form { screen, lines, json };
  Form form = Form::screen;
  std::vector<std::string> patterns{};  // of signals; all when empty
  double interval = 1.0;                // [s] between values
  double seconds = 0.0;                 // until it leaves; 0: when asked to
  bool list = false;                    // the signals once, then leave
  bool stop = false;                    // stop the rendering, then leave
};

/// What `trocar watch` does: follows the previews of a live stream and tells of them.
class Watcher : public QObject {
  Q_OBJECT

 public:
  /// @param print takes what belongs on standard output, complain on standard error
  using Print = std::function<void(const std::string& line)>;
  Watcher(WatchOptions options, Print print, Print complain);

  void open(const QUrl& url);
  void key(char which);
  WatchView view() const;

 Q_SIGNALS:
  /// @param status 0 when what was asked came about, 1 when not
  void done(int status);
  void changed();

 private:
  void follow_channels();
  void take(const stream::Channel& channel, std::span<const std::byte> bytes);
  void take_event(std::span<const std::byte> bytes);
  void take_state(std::span<const std::byte> bytes);
  void tell_link();
  void tell_values();
  void look();
  void stop();
  void remark(const std::string& text);
  void tell(const nlohmann::ordered_json& json);
  double now_s() const { return 1e-9 * static_cast<double>(clock_.nsecsElapsed()); }
  bool is_json() const { return options_.form == WatchOptions::Form::json; }

  WatchOptions options_;
  Print print_, complain_;
  StreamClient client_;
  StreamState state_;
  std::vector<std::unique_ptr<WatchedThread>> threads_;
  std::vector<std::uint32_t> subscribed_;
  std::vector<std::string> remarks_;
  StopCheck stop_;
  bool stop_told_ = false, was_open_ = false;
  LinkState link_told_ = LinkState::closed;
  QElapsedTimer clock_;
  QTimer look_, tell_;
};

}  // namespace trocar::gui
