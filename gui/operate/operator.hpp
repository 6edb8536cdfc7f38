// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <string>

#include "gui/operate/alarms.hpp"
#include "gui/operate/named_signals.hpp"
#include "gui/operate/parameters.hpp"
#include "gui/operate/recording.hpp"
#include "gui/operate/run_status.hpp"
#include "gui/operate/stop_control.hpp"

namespace trocar::gui {

/// All that an operator can know and do, without a window.
class Operator : public QObject {
  Q_OBJECT

 public:
  explicit Operator(const Sources& sources, QObject* parent = nullptr);

  const Sources& sources() const { return sources_; }
  const NamedSignals& named() const { return named_; }
  void set_graph(const nlohmann::json& graph);
  /// docs/log-format.md#graphjson, of a run or a log; null until it is known.
  const nlohmann::json& graph() const { return graph_; }
  /// The runtime was a process of ours, and is gone (or is there again).
  void set_runtime_ended(bool ended) { runtime_ended_ = ended; }
  /// As the newest rows say; made anew by refresh().
  const RunStatus& status() const { return status_; }
  void refresh();

  /// Of the script that runs: its name, and of its text what tells one version from another.
  QString mark() const;
  static QString mark_of(const std::string& script, const std::string& sha256);

  StopControl& stop_control() { return stop_; }
  AlarmModel& alarms() { return alarms_; }
  ParameterModel& parameters() { return parameters_; }
  RecordingControl& recording() { return recording_; }

  /// Asks the runtime; `remark` says what it refused.
  void request(const char* service);
  void annotate(const QString& text);

 Q_SIGNALS:
  void named_changed();
  void remark(const QString& text);

 private:
  void hear_event(const RunEvent& event);
  void follow_caps();

  Sources sources_;
  nlohmann::json graph_;
  NamedSignals named_;
  RunStatus status_;
  StopControl stop_;
  AlarmModel alarms_;
  ParameterModel parameters_;
  RecordingControl recording_;
  QElapsedTimer last_rows_;
  bool runtime_ended_ = false;
};

}  // namespace trocar::gui
