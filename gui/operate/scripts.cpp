// SPDX-License-Identifier: Apache-2.0
#include "gui/operate/scripts.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace trocar::gui {
namespace {

/// A component is a law in Lua when it tells what its script takes.
bool is_law(const nlohmann::json& node) {
  const auto outputs = node.find("outputs");
  return outputs != node.end() && outputs->is_array() &&
         std::any_of(outputs->begin(), outputs->end(), [](const nlohmann::json& one) {
           return one.is_object() && one.value("name", "") == "script.time";
         });
}

double last(const DataStore& data, const QString& component, const char* output) {
  const auto signal = data.find((component + output).toStdString());
  return signal ? signal->last() : 0.0;
}

}  // namespace

ScriptModel::ScriptModel(const Sources& sources, QObject* parent)
    : QAbstractTableModel(parent), sources_(sources) {
  connect(&sources_.data, &DataStore::event_added, this, &ScriptModel::hear_event);
}

void ScriptModel::set_graph(const nlohmann::json& graph) {
  std::vector<LawScript> found;
  const auto nodes = graph.is_object() ? graph.find("nodes") : graph.end();
  if (nodes != graph.end() && nodes->is_array())
    for (const nlohmann::json& node : *nodes) {
      if (!node.is_object() || !is_law(node)) continue;
      LawScript law;
      law.component = QString::fromStdString(node.value("name", ""));
      // "A fixture in Lua: membrane.lua"
      law.file = QString::fromStdString(node.value("doc", "")).section(": ", -1);
      found.push_back(law);
    }
  beginResetModel();
  for (LawScript& law : found)
    for (const LawScript& before : scripts_)
      if (before.component == law.component) law.verdict = before.verdict;
  scripts_ = std::move(found);
  endResetModel();
}

void ScriptModel::refresh() {
  if (scripts_.empty()) return;
  for (LawScript& law : scripts_) {
    law.time = last(sources_.data, law.component, ".script.time");
    law.allocations = last(sources_.data, law.component, ".script.allocations");
    law.memory = last(sources_.data, law.component, ".script.memory");
    const auto signal = sources_.data.find((law.component + ".script.time").toStdString());
    if (!signal) continue;
    const Extremes all =
        signal->column().extremes(signal->track->first(), signal->track->view_end());
    law.worst_time = all.empty() ? 0.0 : all.max;
  }
  Q_EMIT dataChanged(index(0, time), index(rowCount() - 1, memory));
}

void ScriptModel::reload(int row) {
  if (row < 0 || row >= rowCount() || sources_.link == nullptr) return;
  const QString wanted = scripts_[static_cast<std::size_t>(row)].component;
  judge(wanted, "asked");
  sources_.link->call(
      "reload", {{"component", wanted.toStdString()}},
      [this, wanted](const nlohmann::json& answer, const std::string& trouble) {
        const std::string told =
            !trouble.empty()
                ? trouble
                : (answer.is_object() ? answer.value("trouble", std::string()) : std::string());
        if (!told.empty()) return judge(wanted, "refused: " + QString::fromStdString(told));
        take_file(wanted, QString::fromStdString(answer.value("file", std::string())));
      });
}

/// What came of it in the loop.
void ScriptModel::hear_event(const RunEvent& event) {
  if (!event.kind.starts_with("reload")) return;
  const QString why = QString::fromStdString(event.detail);
  const QString of = QString::fromStdString(event.source);
  const QString what = event.kind == "reloaded"        ? "took over"
                       : event.kind == "reload undone" ? "was given up"
                                                       : "refused";
  judge(of,
        QString("%1 at tick %2%3").arg(what).arg(event.tick).arg(why.isEmpty() ? "" : ": " + why));
}

void ScriptModel::judge(const QString& of, const QString& said) {
  change(of, [&](LawScript& law) { law.verdict = said; });
}

/// The loop may have judged it before the answer came.
void ScriptModel::take_file(const QString& of, const QString& path) {
  change(of, [&](LawScript& law) {
    law.file = path;
    if (law.verdict == "asked") law.verdict = "checked, waits for the loop";
  });
}

void ScriptModel::change(const QString& of, const std::function<void(LawScript&)>& edit) {
  for (std::size_t i = 0; i < scripts_.size(); ++i) {
    if (scripts_[i].component != of) continue;
    edit(scripts_[i]);
    const int row = static_cast<int>(i);
    Q_EMIT dataChanged(index(row, 0), index(row, columns - 1));
  }
}

int ScriptModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(scripts_.size());
}

int ScriptModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant ScriptModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const LawScript& law = scripts_[static_cast<std::size_t>(index.row())];
  if (role == Qt::ToolTipRole) return index.column() == file ? law.file : law.verdict;
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case component:
      return law.component;
    case file:
      return law.file;
    case time:
      return QString("%1 µs").arg(1e6 * law.time, 0, 'f', 1);
    case worst_time:
      return QString("%1 µs").arg(1e6 * law.worst_time, 0, 'f', 1);
    case allocations:
      return QString::number(law.allocations, 'f', 0);
    case memory:
      return QString("%1 KiB").arg(law.memory / 1024, 0, 'f', 1);
    case verdict:
      return law.verdict;
    default:
      return {};
  }
}

QVariant ScriptModel::headerData(int section, Qt::Orientation orientation, int role) const {
  static const char* const names[] = {"law",         "file",   "time of a step", "worst",
                                      "allocations", "memory", "reload"};
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole || section >= columns) return {};
  return QString(names[section]);
}

}  // namespace trocar::gui
