// SPDX-License-Identifier: Apache-2.0
#include "framework/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>

#include "framework/graph_json.hpp"
#include "framework/literal_json.hpp"
#include "framework/logger.hpp"
#include "framework/run_settings_json.hpp"

namespace trocar {
namespace {

std::uint64_t date_ns() {
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(
                                        std::chrono::system_clock::now().time_since_epoch())
                                        .count());
}

const Logger* find_logger(const Graph& graph) {
  for (NodeId id = 0; id < graph.size(); ++id)
    if (const auto* logger = dynamic_cast<const Logger*>(graph.node(id).component.get()))
      return logger;
  return nullptr;
}

using Patterns = std::set<std::string, std::less<>>;

/// "wall" and "wall.force" want the port "wall.force"; so does "wall.force.z".
bool wants(const Patterns& patterns, const std::string& port) {
  for (std::size_t dot = port.find('.');; dot = port.find('.', dot + 1)) {
    if (patterns.contains(std::string_view(port).substr(0, dot))) return true;
    if (dot == std::string::npos) break;
  }
  const auto inside = patterns.lower_bound(port + ".");
  return inside != patterns.end() && inside->starts_with(port + ".");
}

}  // namespace

Session::Session(const Registry& registry, SessionOptions options)
    : options_(std::move(options)), graph_(registry), captures_(options_.black_box) {
  graph_.overrides = options_.set;
}

void Session::add_script(std::string name, std::string text) {
  if (log_) try_log([&] { log_->attach(name, "text/x-lua", text); });
  for (Service* service : options_.services) service->add_script(name, text);
  scripts_.emplace_back(std::move(name), std::move(text));
}

RowLayout::Selection Session::selection() const {
  const Logger* logger = find_logger(graph_);
  if (logger == nullptr) return {};
  Patterns patterns;
  if (const auto* one = logger->signals->as<std::string>()) patterns = {*one};
  if (const auto* list = logger->signals->as<Literal::List>())
    for (const Literal& each : *list)
      if (const auto* pattern = each.as<std::string>()) patterns.insert(*pattern);
  if (patterns.empty() || patterns == Patterns{"all"}) return {};
  return [patterns](const std::string& port) { return wants(patterns, port); };
}

/// @param wired the graph as its first run has it; null where nothing ran
void Session::open_log(const WiredGraph* wired) {
  if (log_opened_) return;
  log_opened_ = true;
  if (!options_.write_files || (!options_.record && find_logger(graph_) == nullptr)) return;
  log_path_ = wanted_log();
  log_ =
      std::make_unique<LogFile>(log_path_, options_.clock == ClockKind::simulated ? 0 : date_ns());
  for (const auto& [name, text] : scripts_) log_->attach(name, "text/x-lua", text);
  log_->attach("graph.json", "application/json", graph_json(graph_, wired));
  for (const Published& one : published_) log_->publish(one.name, literal_json(one.row));
}

/// Where it is to be recorded, or "".
std::string Session::wanted_log() const {
  const Logger* logger = find_logger(graph_);
  return options_.record ? *options_.record : logger != nullptr ? *logger->file : "";
}

/// What the black box is named after: the log, else the script.
std::string Session::stem() const {
  if (!log_path_.empty()) return std::filesystem::path(log_path_).replace_extension().string();
  return scripts_.empty() ? "trocar"
                          : std::filesystem::path(scripts_.front().first).stem().string();
}

std::vector<RowSink*> Session::begin_captures(const WiredGraph& wired) {
  if (!options_.write_files || !captures_.wanted(graph_)) return {};
  SessionCaptures::Run run{.graph = graph_, .stem = stem()};
  if (log_)
    run.epoch_ns = log_->start_ns();
  else if (options_.clock != ClockKind::simulated)
    run.epoch_ns = date_ns();
  for (const auto& [name, text] : scripts_) run.attachments.push_back({name, "text/x-lua", text});
  run.attachments.push_back({"graph.json", "application/json", graph_json(graph_, &wired)});
  return captures_.begin(run);
}

/// What took over, or was refused, under names of this run, for the same name may come twice.
void Session::attach_reloads(const RunResult& result) {
  for (std::size_t i = 0; i < result.reloads.size(); ++i) {
    const ReloadVerdict& one = result.reloads[i];
    log_->attach(fmt::format("run{}.reload{}.{}", runs_.size() + 1, i + 1, one.file), "text/x-lua",
                 one.code);
  }
}

/// Rows to all of them; each may intervene, as whoever started the session.
void Session::add_services(RunOptions& wanted) const {
  for (Service* service : options_.services) wanted.sinks.push_back(&service->rows());
  wanted.operator_input = options_.operator_input;
  if (options_.services.empty()) return;
  wanted.reader_failed = [this](const ReaderFailure& failure) {
    if (failure.reader != Recorder::name) return;
    for (Service* service : options_.services) service->recording_failed(failure.why);
  };
  wanted.operator_input = [this](RunControl& control) {
    bool found = options_.operator_input && options_.operator_input(control);
    for (Service* service : options_.services) found = service->operate(control) || found;
    return found;
  };
}

const SessionRun& Session::run(RunOptions wanted) {
  wanted.clock = options_.clock;
  wanted.timing = options_.timing;
  if (options_.duration) wanted.duration = options_.duration;
  if (!wanted.duration && options_.clock == ClockKind::simulated)
    wanted.duration = options_.default_duration;
  if (options_.seed) wanted.wiring.seed = *options_.seed;
  wanted.wiring.virtual_time = options_.clock == ClockKind::simulated;
  wanted.allocations = options_.allocations;
  wanted.stop = options_.stop;
  wanted.wiring.reloadable = options_.reloadable;
  for (const auto& [key, setting] : options_.set) wanted.wiring.set.erase(key);
  const std::unique_ptr<WiredGraph> wired = wire(graph_, wanted.wiring);  // before a log is begun
  if (const std::string wrong = check_spin(wanted, graph_);
      wanted.clock != ClockKind::simulated && !wrong.empty()) {
    Findings findings;
    findings.add({"--spin", 0}, wrong);
    throw BrokenGraph(findings);
  }
  captures_.check_files(graph_, wanted_log());
  open_log(wired.get());
  if (log_)
    try_log([&] {
      log_->attach(fmt::format("run{}.json", runs_.size() + 1), "application/json",
                   run_settings_json(wanted, options_.set));
    });
  auto one = std::make_unique<SessionRun>();
  std::unique_ptr<Recorder> recorder;
  wanted.sinks.push_back(&one->highlights);
  if (log_) {
    recorder = std::make_unique<Recorder>(*log_, selection());
    wanted.sinks.push_back(recorder.get());
  }
  const std::vector<RowSink*> captures = begin_captures(*wired);
  wanted.sinks.insert(wanted.sinks.end(), captures.begin(), captures.end());
  if (options_.watch != nullptr) wanted.sinks.push_back(options_.watch);
  add_services(wanted);
  for (Service* service : options_.services)
    service->prepare({.virtual_time = wanted.wiring.virtual_time,
                      .graph = graph_json(graph_, wired.get()),
                      .recording = log_path_,
                      .stop = options_.stop});
  one->result = trocar::run(graph_, wanted);
  if (log_) try_log([&] { attach_reloads(one->result); });
  one->captured = captures_.end();
  for (const std::string& message : one->captured.troubles) trouble(message);
  runs_.push_back(std::move(one));
  return *runs_.back();
}

void Session::publish(std::string name, Literal row) {
  if (log_) try_log([&] { log_->publish(name, literal_json(row)); });
  published_.push_back({std::move(name), std::move(row)});
}

void Session::finish() {
  if (!published_.empty()) try_log([&] { open_log(nullptr); });
  if (log_) try_log([&] { log_->close(); });
}

/// A full disk must not end an experiment, and one message is enough.
void Session::try_log(const std::function<void()>& write) {
  try {
    write();
  } catch (const std::runtime_error& error) {
    trouble(error.what());
  }
}

void Session::trouble(const std::string& message) {
  if (std::find(troubles_.begin(), troubles_.end(), message) == troubles_.end())
    troubles_.push_back(message);
}

bool Session::sound() const {
  return troubles_.empty() && std::all_of(runs_.begin(), runs_.end(), [](const auto& run) {
           const RunResult& result = run->result;
           return result.faults.empty() && result.lost.empty() &&
                  std::all_of(
                      result.threads.begin(), result.threads.end(),
                      [](const ThreadResult& thread) { return thread.loop.rows_lost == 0; }) &&
                  std::none_of(result.missed.begin(), result.missed.end(),
                               [](const ReaderLoss& loss) { return loss.matters; });
         });
}

}  // namespace trocar
