// SPDX-License-Identifier: Apache-2.0
#include "framework/session_captures.hpp"

#include <fmt/format.h>

#include "framework/capture.hpp"

namespace trocar {
namespace {

constexpr const char* black_box_name = "black box";

std::vector<const Graph::Node*> captures_in(const Graph& graph) {
  std::vector<const Graph::Node*> captures;
  for (NodeId id = 0; id < graph.size(); ++id)
    if (dynamic_cast<const Capture*>(graph.node(id).component.get()) != nullptr)
      captures.push_back(&graph.node(id));
  return captures;
}

const std::string& file_of(const Graph::Node& node) {
  return *dynamic_cast<const Capture&>(*node.component).file;
}

}  // namespace

bool SessionCaptures::wanted(const Graph& graph) const {
  return black_box_ || !captures_in(graph).empty();
}

void SessionCaptures::check_files(const Graph& graph, const std::string& log_path) const {
  Findings findings;
  std::map<std::string, std::string> writers;  // by file
  if (!log_path.empty()) writers[log_path] = "the log";
  if (black_box_ && black_box_->file) writers[*black_box_->file] = "the black box";
  for (const Graph::Node* node : captures_in(graph)) {
    const auto [writer, is_new] = writers.emplace(file_of(*node), node->name);
    if (!is_new)
      findings.add(node->where, fmt::format("{}.file = \"{}\": that is written by {}: give another",
                                            node->name, file_of(*node), writer->second));
  }
  if (!findings.empty()) throw BrokenGraph(findings);
}

std::vector<RowSink*> SessionCaptures::begin(const Run& run) {
  active_.clear();
  if (black_box_) {
    const std::string file = black_box_->file.value_or(run.stem + ".blackbox-1.mcap");
    add(run, black_box_name,
        std::make_unique<FaultTrigger>(Trigger::Window{black_box_->before, black_box_->after}),
        FileSeries(file, FileSeries::Existing::passed_over));
  }
  for (const Graph::Node* node : captures_in(run.graph))
    add(run, node->name, std::make_unique<SignalTrigger>(node->name),
        FileSeries(file_of(*node), FileSeries::Existing::replaced));
  std::vector<RowSink*> sinks;
  for (const One& one : active_) sinks.push_back(one.log.get());
  return sinks;
}

void SessionCaptures::add(const Run& run, const std::string& name, std::unique_ptr<Trigger> trigger,
                          const FileSeries& series) {
  Files& files = files_.emplace(name, Files{series}).first->second;
  TriggeredLog::Options options{.name = name,
                                .epoch_ns = run.epoch_ns,
                                .most_files = files.left,
                                .attachments = run.attachments,
                                .next_path = [&files] {
                                  --files.left;
                                  return files.series.next();
                                }};
  auto log = std::make_unique<TriggeredLog>(*trigger, std::move(options));
  active_.push_back({name, std::move(trigger), std::move(log)});
}

CaptureResult SessionCaptures::end() {
  CaptureResult result;
  for (const One& one : active_) {
    const TriggeredLog& log = *one.log;
    result.files.insert(result.files.end(), log.files().begin(), log.files().end());
    result.troubles.insert(result.troubles.end(), log.troubles().begin(), log.troubles().end());
    if (log.refused() > 0)
      result.notes.push_back(fmt::format("{}: {} more were not written, a session has {} files",
                                         one.name, log.refused(), most_files));
  }
  return result;
}

}  // namespace trocar
