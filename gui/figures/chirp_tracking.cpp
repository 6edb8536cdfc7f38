// SPDX-License-Identifier: Apache-2.0
#include "gui/figures/chirp_tracking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/least_squares.hpp"

namespace trocar::gui {
namespace {

using Json = nlohmann::json;

constexpr double interval = 1e-3;  // [s] of the rows that are taken

const Json* node_called(const Json& graph, const std::string& name) {
  for (const Json& node : graph.at("nodes"))
    if (node.at("name") == name) return &node;
  return nullptr;
}

const Json& parameter(const Json& node, const char* name) {
  for (const Json& one : node.at("parameters"))
    if (one.at("name") == name) return one;
  throw FigureError(fmt::format("{} has no parameter {} in the log's graph",
                                node.at("name").get<std::string>(), name));
}

double seconds_of(const Json& node, const char* name) {
  return parameter(node, name).at("si").at(0).get<double>();
}

struct Chirp {
  std::string motion, spring, axis;
  double from = 0.0, to = 0.0;  // [s]
};

Chirp chirp_in(const Json& graph) {
  for (const Json& wire : graph.at("wires")) {
    const Json &source = wire.at("source"), &target = wire.at("target");
    const Json* motion = node_called(graph, source.at("node").get<std::string>());
    const Json* spring = node_called(graph, target.at("node").get<std::string>());
    if (motion == nullptr || spring == nullptr || motion->at("type") != "ChirpMotion" ||
        spring->at("type") != "PoseSpring" || target.at("input") != "offset")
      continue;
    std::string axis = parameter(*motion, "axis").at("value").get<std::string>();
    std::erase(axis, '"');
    const double begin = seconds_of(*motion, "begin");
    return {.motion = motion->at("name"),
            .spring = spring->at("name"),
            .axis = std::move(axis),
            .from = begin,
            .to = begin + seconds_of(*motion, "duration")};
  }
  throw FigureError("no ChirpMotion moves a PoseSpring in the log's graph");
}

Chirp chirp_of(const ResultFile& file) {
  const std::string needs =
      "chirp needs a log with the rows of a ChirpMotion whose offset goes to a PoseSpring, as "
      "scripts/experiments/chirp.lua --record writes it; ";
  if (file.log() == nullptr) throw FigureError(needs + "this is " + file.contents());
  if (!file.graph().is_object()) throw FigureError(needs + "this log has no graph.json");
  try {
    return chirp_in(file.graph());
  } catch (const FigureError& error) {
    throw FigureError(needs + error.what());
  } catch (const Json::exception&) {
    throw FigureError(needs + "this log's graph.json is not one of Trocar");
  }
}

void fit(ChirpTracking& chirp, const std::vector<double>& speed) {
  const std::vector<std::vector<double>> columns = {chirp.reference, speed};
  LinearFit found;
  try {
    found = fit_linear(columns, chirp.tip);
  } catch (const std::invalid_argument& error) {
    throw FigureError(std::string("the chirp cannot be fitted: ") + error.what());
  }
  chirp.gain = found.solution[0];
  chirp.lag = -found.solution[1] / found.solution[0];
  double squares = 0.0;
  for (const double error : chirp.error) {
    squares += error * error;
    chirp.worst = std::max(chirp.worst, std::abs(error));
  }
  chirp.rms = std::sqrt(squares / static_cast<double>(chirp.error.size()));
}

}  // namespace

ChirpTracking chirp_tracking(const ResultFile& file, int run, const std::string& thread) {
  const Chirp found = chirp_of(file);
  const std::string goal = found.motion + ".offset." + found.axis,
                    speed = found.motion + ".velocity." + found.axis,
                    error = found.spring + ".displacement." + found.axis;
  auto rows = file.signals_of({"time", goal, speed, error}, run, thread);
  const std::vector<double>& time = rows["time"];
  const double period = time.size() > 1 ? time[1] - time[0] : interval;
  const auto every = static_cast<std::size_t>(std::max(1.0, std::round(interval / period)));
  ChirpTracking chirp{.axis = found.axis, .time = {}, .reference = {}, .tip = {}, .error = {}};
  std::vector<double> speeds;
  for (std::size_t i = 0; i < time.size(); i += every) {
    if (time[i] < found.from || time[i] > found.to) continue;
    chirp.time.push_back(time[i]);
    chirp.reference.push_back(rows[goal][i]);
    chirp.error.push_back(rows[error][i]);
    chirp.tip.push_back(rows[goal][i] + rows[error][i]);
    speeds.push_back(rows[speed][i]);
  }
  fit(chirp, speeds);
  return chirp;
}

std::string tracking_text(const ChirpTracking& chirp) {
  return fmt::format(
      "{}: error {:.4f} mm RMS, {:.4f} mm at worst; gain {:.5f}, lag {:.3f} ms, {} rows",
      chirp.axis, 1e3 * chirp.rms, 1e3 * chirp.worst, chirp.gain, 1e3 * chirp.lag,
      chirp.time.size());
}

}  // namespace trocar::gui
