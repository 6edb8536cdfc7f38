// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "framework/registry.hpp"
#include "framework/session.hpp"

namespace trocar::cli {

/// --serve: the session as a live stream, by a plugin's service.
class Serving {
 public:
  void add_to(CLI::App& command);
  /// Starts what was asked for. @param options of a session that this outlives
  /// @throw CLI::ValidationError when it cannot be
  void start(const Registry& registry, SessionOptions& options);

 private:
  std::optional<std::string> address_;
  bool wait_ = false;
  std::unique_ptr<Service> service_;
};

}  // namespace trocar::cli
