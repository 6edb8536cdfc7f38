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

bool RecordingControl::can_end() const {
  return sources_.live != nullptr && !sources_.live->state().recording.file.empty();
}

bool RecordingControl::recording() const {
  return can_end() || (sources_.live != nullptr && sources_.live->state().running &&
                       !sources_.live->state().log.empty());
}

QString RecordingControl::trial() const {
  if (!trial_.empty()) return QString::fromStdString(trial_);
  return sources_.live == nullptr ? "" : QString::fromStdString(sources_.live->state().log);
}

std::uint64_t RecordingControl::rows_seen() const {
  std::uint64_t rows = 0;
  for (const auto& track : sources_.data.tracks()) rows += track->end();
  return rows;
}

std::int64_t RecordingControl::lost() const {
  const std::uint64_t seen = rows_seen();
  const bool counts = !trouble_.isEmpty() && !trial().isEmpty() && seen > seen_at_good_;
  return missed_ + (counts ? static_cast<std::int64_t>(seen - seen_at_good_) : 0);
}

QString RecordingControl::text() const {
  if (!trouble_.isEmpty()) return "RECORDING FAILED";
  if (!recording()) return incomplete_ ? "not recording; trial INCOMPLETE" : "not recording";
  const auto seconds = static_cast<int>(sources_.live->state().time - began_);
  return QString("REC %1:%2 lost %3%4")
      .arg(seconds / 60, 2, 10, QChar('0'))
      .arg(seconds % 60, 2, 10, QChar('0'))
      .arg(lost())
      .arg(incomplete_ ? " INCOMPLETE" : "");
}

QString RecordingControl::failure() const {
  if (trouble_.isEmpty()) return "";
  QString text = "RECORDING FAILED: " + trouble_;
  if (!trial().isEmpty())
    text += QString("; %1 rows lost, and %2 is INCOMPLETE").arg(lost()).arg(trial());
  return text + "; forces go on";
}

void RecordingControl::start(const QString& file) {
  if (sources_.link == nullptr) return;
  trouble_.clear();
  nlohmann::json arguments = {{"on", true}};
  if (!file.isEmpty()) arguments["file"] = file.toStdString();
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
    if (!file_.empty()) {  // another trial
      trial_ = file_;
      trouble_.clear();
      incomplete_ = false;
    }
  }
  if (!file_.empty()) missed_ = state.recording.missed;
  const bool log_is_good = trial_.empty() && !state.log.empty() && state.log_trouble.empty();
  if (!file_.empty() || log_is_good) seen_at_good_ = rows_seen();
  if (state.recording.missed > 0) incomplete_ = true;
  if (!state.trouble.empty()) fail(QString::fromStdString(state.trouble));
  // Who comes later hears of it too; who has begun a recording of his own since has heard enough.
  const bool is_news = state.log_trouble != log_trouble_ && file_.empty();
  log_trouble_ = state.log_trouble;
  if (is_news && !log_trouble_.empty()) fail(QString::fromStdString(log_trouble_));
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
