// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <string>

#include "gui/link/stop_check.hpp"
#include "gui/operate/named_signals.hpp"
#include "gui/window/page.hpp"

namespace trocar::gui {

/// The software stop: asks the runtime to end the rendering, and says whether rows that came after
/// confirm it. Asking again asks anew; what did not get through is asked again once it can.
class StopControl : public QObject {
  Q_OBJECT

 public:
  enum class State { idle, stopping, confirmed, not_confirmed };

  explicit StopControl(const Sources& sources, QObject* parent = nullptr);

  /// By what a device's rows are judged.
  void set_signals(const NamedSignals& signals) { signals_ = signals; }

  void stop();
  State state() const { return state_; }
  double confirmed_after() const { return check_.confirmed_after().value_or(0.0); }  // [s]
  /// "STOPPED, confirmed after 8 ms"; "" while nothing was asked.
  std::string text() const { return check_.text(now_s()); }
  /// Nothing is said of a confirmed stop any more: it renders again.
  void forget();

 Q_SIGNALS:
  void changed();
  /// 250 ms went by: what the dashboard started itself is to be ended.
  void not_confirmed();

 private:
  void ask();
  void hear_event(const RunEvent& event);
  void look();
  void set_state(State state);
  double now_s() const { return 1e-9 * static_cast<double>(clock_.nsecsElapsed()); }
  std::int64_t newest_tick() const;

  Sources sources_;
  NamedSignals signals_;
  StopCheck check_;
  bool lost_ = false;          // what was asked did not get through
  bool acted_ = false;         // the loop said at which tick it obeyed
  std::int64_t asked_at_ = 0;  // newest tick
  State state_ = State::idle;
  QElapsedTimer clock_;
  QTimer look_;
};

}  // namespace trocar::gui
