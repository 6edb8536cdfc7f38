// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "framework/literal_json.hpp"
#include "framework/report.hpp"

namespace trocar {
namespace {

using Json = nlohmann::ordered_json;

Json timing(const TimingHistogram& histogram) {
  return {{"count", histogram.count()},
          {"mean", histogram.mean() * 1e-9},
          {"p50", static_cast<double>(histogram.percentile(0.5)) * 1e-9},
          {"p99", static_cast<double>(histogram.percentile(0.99)) * 1e-9},
          {"p999", static_cast<double>(histogram.percentile(0.999)) * 1e-9},
          {"max", static_cast<double>(histogram.max()) * 1e-9}};
}

Json vector(const Vector3& v) {
  return Json::array({v.x, v.y, v.z});
}

Json highlights(const Highlights& all) {
  Json list = Json::array();
  for (const Highlight& one : all.all())
    list.push_back({{"signal", one.name},
                    {"unit", one.unit},
                    {"peak", one.peak},
                    {"peak_time", one.peak_time},
                    {"at_peak", vector(one.at_peak)},
                    {"last", vector(one.last)}});
  return list;
}

Json faults(const RunResult& result) {
  Json list = Json::array();
  for (const FaultRecord& fault : result.faults)
    list.push_back({{"cause", fault.cause},
                    {"component", fault.component},
                    {"detail", fault.detail},
                    {"value", fault.value},
                    {"limit", fault.limit},
                    {"tick", fault.tick},
                    {"time", fault.time}});
  return list;
}

Json missed(const RunResult& result) {
  Json list = Json::array();
  for (const ReaderLoss& loss : result.missed)
    list.push_back({{"reader", loss.reader},
                    {"records", loss.records},
                    {"gaps", loss.gaps},
                    {"time", loss.time}});
  return list;
}

Json thread_json(const ThreadResult& thread) {
  Json components = Json::object();
  for (const ComponentTiming& component : thread.components)
    components[component.name] = timing(component.time);
  return {{"name", thread.name},
          {"rate", thread.rate},
          {"ticks", thread.loop.ticks},
          {"skipped", thread.loop.skipped},
          {"overruns", thread.loop.overruns},
          {"spun", static_cast<double>(thread.loop.spun_ns) * 1e-9},
          {"rows", thread.loop.rows},
          {"rows_lost", thread.loop.rows_lost},
          {"lateness", timing(thread.loop.lateness)},
          {"tick_time", timing(thread.loop.duration)},
          {"components", components}};
}

Json captured(const CaptureResult& all) {
  Json list = Json::array();
  for (const TriggeredFile& file : all.files)
    list.push_back({{"by", file.writer},
                    {"file", file.path},
                    {"cause", file.cause},
                    {"from", file.from},
                    {"to", file.to},
                    {"rows", file.rows}});
  return list;
}

Json reloads(const RunResult& result) {
  Json list = Json::array();
  for (const ReloadVerdict& verdict : result.reloads)
    list.push_back({{"component", verdict.component},
                    {"file", verdict.file},
                    {"time", verdict.time},
                    {"trouble", verdict.trouble}});
  return list;
}

Json run_json(const SessionRun& run) {
  const RunResult& result = run.result;
  Json threads = Json::array();
  for (const ThreadResult& thread : result.threads) threads.push_back(thread_json(thread));
  Json first = threads.front();  // its figures stand with the run as well
  first.erase("name");
  Json all = {{"clock", to_string(result.clock)},
              {"duration", result.duration},
              {"wall_time", result.wall_time},
              {"speed", result.wall_time > 0.0 ? result.duration / result.wall_time : 0.0},
              {"interrupted", result.interrupted},
              {"spin", result.spin},
              {"latency_held", result.latency_held}};
  all.update(first);
  all.update({{"threads", threads},
              {"highlights", highlights(run.highlights)},
              {"faults", faults(result)},
              {"reloads", reloads(result)},
              {"shortcomings", result.shortcomings},
              {"lost", result.lost},
              {"missed", missed(result)},
              {"captured", captured(run.captured)},
              {"notes", run.captured.notes}});
  return all;
}

}  // namespace

std::string report_json(const Session& session) {
  Json runs = Json::array();
  for (const auto& run : session.runs()) runs.push_back(run_json(*run));
  Json published = Json::object();
  for (const Published& one : session.published())
    published[one.name].push_back(Json::parse(literal_json(one.row)));
  const Json all = {{"runs", runs},
                    {"published", published},
                    {"log", session.log_path().empty() ? Json() : Json(session.log_path())},
                    {"troubles", session.troubles()}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace trocar
