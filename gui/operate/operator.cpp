// SPDX-License-Identifier: Apache-2.0
#include "gui/operate/operator.hpp"

#include <nlohmann/json.hpp>

namespace trocar::gui {

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
  }
  if (sources_.link != nullptr)
    connect(sources_.link, &StreamClient::status, this, [this](const stream::Status& status) {
      if (status.level != stream::StatusLevel::info)
        Q_EMIT remark(QString::fromStdString(status.text));
    });
}

void Operator::set_graph(const nlohmann::json& graph) {
  named_ = NamedSignals::of(graph);
  Q_EMIT named_changed();
}

void Operator::refresh() {
  status_ = RunStatus::of(sources_, named_);
  if (status_.state == RunState::engaged || status_.state == RunState::engaging) stop_.forget();
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
