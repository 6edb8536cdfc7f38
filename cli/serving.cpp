// SPDX-License-Identifier: Apache-2.0
#include "cli/serving.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace trocar::cli {
namespace {

constexpr const char* stream_name = "foxglove";

}  // namespace

void Serving::add_to(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--serve", [this](const std::string& address) { address_ = address; },
          "Serve a live stream for dashboards (Foxglove, Lichtblick, PlotJuggler), by default at "
          "127.0.0.1:8765; TROCAR_TOKEN is what remote clients need to change anything")
      ->expected(0, 1)
      ->type_name("[ADDR:PORT]");
  command.add_flag("--wait", wait_, "With --serve: begin when a client calls start");
}

void Serving::start(const Registry& registry, SessionOptions& options) {
  if (wait_ && !address_)
    throw CLI::ValidationError("--wait", "needs --serve: who would start it?");
  if (!address_) return;
  const auto& services = registry.services();
  const auto type = std::find_if(services.begin(), services.end(),
                                 [](const ServiceType& one) { return one.name == stream_name; });
  if (type == services.end())
    throw CLI::ValidationError(
        "--serve",
        "the plugin foxglove is not there: `trocar list plugins` says where plugins are "
        "looked for, and why one was refused");
  ServiceType::Settings settings{{"address", *address_}, {"wait", wait_ ? "true" : "false"}};
  if (const char* token = std::getenv("TROCAR_TOKEN"); token != nullptr) settings["token"] = token;
  try {
    service_ = type->start(settings);
  } catch (const std::exception& error) {
    throw CLI::ValidationError("--serve", error.what());
  }
  fmt::print(stderr, "{}\n", service_->greeting());
  options.services.push_back(service_.get());
  options.reloadable = true;  // a client may ask for it
}

}  // namespace trocar::cli
