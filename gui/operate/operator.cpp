// SPDX-License-Identifier: Apache-2.0
#include "gui/operate/operator.hpp"

#include <nlohmann/json.hpp>

namespace trocar::gui {
namespace {

constexpr std::size_t mark_digits = 8;
constexpr double old_after_s = 2.0;  // what a server tells of before we came is no answer to us

}  // namespace

Operator::Operator(const Sources& sources, QObject* parent)
    : QObject(parent),
      sources_(sources),
      stop_(sources),
      alarms_(sources.data),
      parameters_(sources),
      recording_(sources) {
  if (sources_.live != nullptr) {
    connect(sources_.live, &LiveFeed::graph_known, this,
            [this] { set_graph(sources_.live->graph()); });
    set_graph(sources_.live->graph());
    connect(sources_.live, &LiveFeed::grew, this, [this] { last_rows_.start(); });
    connect(&sources_.data, &DataStore::event_added, this, &Operator::hear_event);
  }
  if (sources_.link != nullptr)
    connect(sources_.link, &StreamClient::status, this, [this](const stream::Status& status) {
      if (status.level != stream::StatusLevel::info)
        Q_EMIT remark(QString::fromStdString(status.text));
    });
}

void Operator::set_graph(const nlohmann::json& graph) {
  graph_ = graph;
  named_ = NamedSignals::of(graph);
  stop_.set_signals(named_);
  Q_EMIT named_changed();
}

QString Operator::mark() const {
  if (sources_.live == nullptr || sources_.live->state().script.empty()) return "";
  const StreamState& state = sources_.live->state();
  return mark_of(state.script, state.sha256);
}

QString Operator::mark_of(const std::string& script, const std::string& sha256) {
  return QString::fromStdString(script + " " + sha256.substr(0, mark_digits));
}

/// The graph tells what they were at first; they can be moved while it runs.
void Operator::follow_caps() {
  if (named_.device.empty()) return;
  const auto follow = [this](const char* name, double& cap) {
    const auto row = parameters_.find(QString::fromStdString(named_.device + name));
    if (!row) return;
    const ParameterView& view = parameters_.parameters()[static_cast<std::size_t>(*row)];
    cap = view.value * view.scale;
  };
  follow(".handle_force_cap", named_.force_cap);
  follow(".handle_moment_cap", named_.moment_cap);
}

void Operator::refresh() {
  alarms_.refresh();
  follow_caps();
  const double silent =
      last_rows_.isValid() ? 1e-3 * static_cast<double>(last_rows_.elapsed()) : 0.0;
  status_ =
      RunStatus::of(sources_, named_, {.rows_silent_for = silent, .runtime_ended = runtime_ended_});
  if (status_.state == RunState::engaged || status_.state == RunState::engaging) stop_.forget();
}

/// What was asked is answered twice: at once that it was taken, and by the loop what came of it.
void Operator::hear_event(const RunEvent& event) {
  const double newest = sources_.data.newest();
  const bool of_old = newest <= 0 || newest - event.time > old_after_s;
  if (of_old || !event.kind.ends_with(" refused")) return;
  const std::string why = !event.detail.empty()                 ? event.detail
                          : event.kind == "acknowledge refused" ? "its cause is not gone yet"
                                                                : "";
  const std::string of = event.source.empty() ? "" : event.source + ": ";
  Q_EMIT remark(QString::fromStdString(of + event.kind + (why.empty() ? "" : ": " + why)));
}

void Operator::request(const char* service) {
  if (sources_.link == nullptr) return Q_EMIT remark("a log is played: nothing can be asked of it");
  const QString asked = service;
  sources_.link->call(service, nlohmann::json::object(),
                      [this, asked](const nlohmann::json&, const std::string& trouble) {
                        if (!trouble.empty())
                          Q_EMIT remark(asked + ": " + QString::fromStdString(trouble));
                      });
}

void Operator::annotate(const QString& text) {
  if (sources_.link == nullptr || text.trimmed().isEmpty()) return;
  sources_.link->call("annotate", {{"text", text.trimmed().toStdString()}},
                      [this](const nlohmann::json&, const std::string& trouble) {
                        if (!trouble.empty())
                          Q_EMIT remark("annotate: " + QString::fromStdString(trouble));
                      });
}

}  // namespace trocar::gui
