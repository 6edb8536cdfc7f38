// SPDX-License-Identifier: Apache-2.0
#include "plugins/foxglove/call_desk.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "framework/command.hpp"
#include "framework/text.hpp"

namespace trocar::foxglove {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_remark = 4000;  // [B]

struct Offer {
  const char* name;
  const char* request;   // JSON schema
  const char* response;  // JSON schema
};

constexpr const char* no_arguments = R"({"type":"object","properties":{}})";
constexpr const char* asked = R"({"type":"object","properties":{"asked":{"type":"string"}}})";

constexpr std::array all_offers = {
    Offer{"stop", no_arguments, asked},
    Offer{"start", no_arguments, asked},
    Offer{"engage", no_arguments, asked},
    Offer{"acknowledge", no_arguments, asked},
    Offer{"home", no_arguments, asked},
    Offer{"end", no_arguments, asked},
    Offer{"record",
          R"({"type":"object","properties":{"on":{"type":"boolean"},"file":{"type":"string"}}})",
          R"({"type":"object","properties":{"file":{"type":"string"},"rows":{"type":"integer"},)"
          R"("missed":{"type":"integer"}}})"},
    Offer{"annotate",
          R"({"type":"object","properties":{"text":{"type":"string"}},"required":["text"]})",
          asked},
    Offer{"reload", R"({"type":"object","properties":{"component":{"type":"string"}}})",
          R"({"type":"object","properties":{"component":{"type":"string"},)"
          R"("file":{"type":"string"},"trouble":{"type":"string"}}})"},
    Offer{"parameters", no_arguments,
          R"({"type":"object","properties":{"parameters":{"type":"array"}}})"},
    Offer{"graph", no_arguments, R"({"type":"object"})"},
};

Json parsed(const std::string& arguments) {
  if (arguments.empty()) return Json::object();
  Json json = Json::parse(arguments, nullptr, false);
  if (!json.is_object()) throw std::invalid_argument("the arguments need to be a JSON object");
  return json;
}

template <typename T>
T argument(const Json& arguments, const char* name, T otherwise) {
  const auto found = arguments.find(name);
  if (found == arguments.end()) return otherwise;
  try {
    return found->get<T>();
  } catch (const Json::exception&) {
    throw std::invalid_argument(fmt::format("\"{}\" = {} does not fit", name, found->dump()));
  }
}

Json finite_or_null(double number) {
  return std::isfinite(number) ? Json(number) : Json();
}

Json parameters_json(RunControl& control) {
  Json list = Json::array();
  for (const ParameterState& one : control.parameters())
    list.push_back({{"name", one.key},
                    {"text", one.text},
                    {"value", one.numbers},
                    {"unit", si_symbol(one.unit.dimension)},
                    {"shown_unit", one.unit.symbol},
                    {"shown_scale", one.unit.scale},
                    {"min", finite_or_null(one.min)},
                    {"max", finite_or_null(one.max)},
                    {"choices", one.choices},
                    {"live", one.live},
                    {"doc", one.doc}});
  return {{"parameters", std::move(list)}};
}

Json record_json(const Json& arguments, Recording& recording) {
  if (argument(arguments, "on", true))
    return {{"file", recording.start(argument(arguments, "file", std::string()))}};
  const Recording::State state = recording.stop();
  return {{"file", state.file}, {"rows", state.rows}, {"missed", state.missed}};
}

Json annotate_json(const Json& arguments, RunControl& control) {
  const auto text = argument(arguments, "text", std::string());
  if (text.empty()) throw std::invalid_argument("\"text\" is missing");
  if (text.size() > longest_remark)
    throw std::invalid_argument(
        fmt::format("\"text\" has {} bytes: at most {}", text.size(), longest_remark));
  control.annotate(text);
  return {{"asked", "annotate"}};
}

/// The law of a component, from its file as it stands now.
Json reload_json(const Json& arguments, RunControl& control) {
  const std::vector<Reloads::Part> parts = control.parts();
  auto component = argument(arguments, "component", std::string());
  if (component.empty() && parts.size() == 1) component = parts.front().component;
  std::vector<std::string> known;
  for (const Reloads::Part& part : parts) {
    known.push_back(part.component);
    if (part.component != component) continue;
    std::ifstream file(part.file, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    if (!file) throw std::runtime_error(fmt::format("{} cannot be read", part.file));
    const std::string trouble = control.reload(
        {.component = component, .file = part.file, .path = part.file, .text = text.str()});
    return {{"component", component}, {"file", part.file}, {"trouble", trouble}};
  }
  throw std::invalid_argument(known.empty() ? "no component's law comes from a file"
                                            : fmt::format("\"{}\" cannot be reloaded{}", component,
                                                          suggestion(component, known)));
}

}  // namespace

std::vector<stream::ServiceOffer> CallDesk::offers() {
  std::vector<stream::ServiceOffer> offers;
  for (const Offer& one : all_offers)
    offers.push_back(
        {static_cast<std::uint32_t>(offers.size() + 1), one.name, one.request, one.response});
  return offers;
}

const std::string& CallDesk::graph() {
  if (auto newer = graph_.take()) graph_now_ = std::move(*newer);
  return graph_now_;
}

std::string CallDesk::call(const std::string& service, const std::string& arguments,
                           RunControl& control) {
  const Json json = parsed(arguments);
  if (const auto kind = request_named(service)) {
    control.request(*kind);
    return Json{{"asked", service}}.dump();
  }
  if (service == "graph") return graph();
  if (service == "parameters") return parameters_json(control).dump();
  if (service == "record") return record_json(json, recording_).dump();
  if (service == "annotate") return annotate_json(json, control).dump();
  if (service == "reload") return reload_json(json, control).dump();
  throw std::invalid_argument(fmt::format("there is no service \"{}\"", service));
}

}  // namespace trocar::foxglove
