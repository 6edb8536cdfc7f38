// SPDX-License-Identifier: Apache-2.0
#include "gui/operate/recording.hpp"

#include <nlohmann/json.hpp>

namespace trocar::gui {

RecordingControl::RecordingControl(const Sources& sources, QObject* parent)
    : QObject(parent), sources_(sources) {
  if (sources_.live != nullptr)
    connect(sources_.live, &LiveFeed::state_heard, this, &RecordingControl::hear);
  if (sources_.link != nullptr)
    connect(sources_.link, &StreamClient::status, this, &RecordingControl::hear_status);
}

bool RecordingControl::recording() const {
  return sources_.live != nullptr &&
         (!sources_.live->state().recording.file.empty() || !sources_.live->state().log.empty());
}

QString RecordingControl::trial() const {
  if (sources_.live == nullptr) return "";
  const StreamState& state = sources_.live->state();
  return QString::fromStdString(state.recording.file.empty() ? state.log : state.recording.file);
}

QString RecordingControl::text() const {
  if (!trouble_.isEmpty()) return "RECORDING FAILED: " + trouble_;
  if (!recording()) return incomplete_ ? "not recording; trial INCOMPLETE" : "not recording";
  const StreamState& state = sources_.live->state();
  const auto seconds = static_cast<int>(state.time - began_);
  return QString("REC %1:%2 lost %3%4")
      .arg(seconds / 60, 2, 10, QChar('0'))
      .arg(seconds % 60, 2, 10, QChar('0'))
      .arg(state.recording.missed)
      .arg(incomplete_ ? " INCOMPLETE" : "");
}

void RecordingControl::start(const QString& file) {
  if (sources_.link == nullptr) return;
  nlohmann::json arguments = {{"on", true}};
  if (!file.isEmpty()) arguments["file"] = file.toStdString();
  trouble_.clear();
  incomplete_ = false;
  sources_.link->call("record", arguments,
                      [this](const nlohmann::json&, const std::string& trouble) {
                        if (!trouble.empty()) fail(QString::fromStdString(trouble));
                      });
}

void RecordingControl::stop() {
  if (sources_.link == nullptr) return;
  sources_.link->call("record", {{"on", false}},
                      [this](const nlohmann::json&, const std::string& trouble) {
                        if (!trouble.empty()) fail(QString::fromStdString(trouble));
                      });
}

void RecordingControl::hear() {
  const StreamState& state = sources_.live->state();
  if (state.recording.file != file_) {
    file_ = state.recording.file;
    began_ = file_.empty() ? 0.0 : state.time;
  }
  if (state.recording.missed > 0) incomplete_ = true;
  if (!state.trouble.empty())
    fail(QString("%1; %2 rows lost")
             .arg(QString::fromStdString(state.trouble))
             .arg(state.recording.missed));
  Q_EMIT changed();
}

void RecordingControl::hear_status(const stream::Status& status) {
  const QString text = QString::fromStdString(status.text);
  if (text.startsWith("recording failed: ")) fail(text.mid(18));
}

void RecordingControl::fail(const QString& why) {
  trouble_ = why;
  incomplete_ = true;
  Q_EMIT changed();
}

}  // namespace trocar::gui
