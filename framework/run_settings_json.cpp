// SPDX-License-Identifier: Apache-2.0
#include "framework/run_settings_json.hpp"

#include <nlohmann/json.hpp>

#include "framework/literal_json.hpp"

namespace trocar {
namespace {

using Json = nlohmann::ordered_json;

Json value_of(const Literal& literal) {
  return Json::parse(literal_json(literal));
}

Json settings(const Graph::Overrides& overrides) {
  Json all = Json::object();
  for (const auto& [key, override] : overrides) all[key] = value_of(override.value);
  return all;
}

}  // namespace

std::string run_settings_json(const RunOptions& options, const Graph::Overrides& overrides) {
  Json edits = Json::array();
  for (const Edit& edit : options.edits)
    edits.push_back({{"at", edit.at}, {"key", edit.key}, {"value", value_of(edit.value)}});
  Json requests = Json::array();
  for (const OperatorRequest& request : options.requests)
    requests.push_back({{"at", request.at}, {"ask", request_name(request.kind)}});
  Json reloads = Json::array();
  for (const Reload& reload : options.reloads)
    reloads.push_back({{"at", reload.at}, {"component", reload.component}, {"file", reload.file}});
  const Json all = {{"rate", options.wiring.rate},
                    {"duration", options.duration ? Json(*options.duration) : Json()},
                    {"seed", options.wiring.seed},
                    {"set", settings(options.wiring.set)},
                    {"edits", edits},
                    {"requests", requests},
                    {"reloads", reloads},
                    {"overrides", settings(overrides)}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace trocar
