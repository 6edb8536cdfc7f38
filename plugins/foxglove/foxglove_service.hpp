// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "framework/realtime/handover.hpp"
#include "framework/realtime/service_thread.hpp"
#include "framework/run_control.hpp"
#include "framework/service.hpp"
#include "plugins/foxglove/access.hpp"
#include "plugins/foxglove/desk.hpp"
#include "plugins/foxglove/tap.hpp"

namespace trocar::foxglove {

/// A session as a live stream, by the Foxglove WebSocket protocol, on a thread of its own.
///
/// Settings: "address" (see parse_endpoint), "token" (a random one by default), "wait" ("true": the
/// first run begins when a client calls start).
class FoxgloveService final : public Service {
 public:
  /// @throw std::invalid_argument for a setting that does not exist or does not fit
  /// @throw std::runtime_error when nobody can listen there
  explicit FoxgloveService(const ServiceType::Settings& settings);
  ~FoxgloveService() override;

  std::string greeting() const override;
  void add_script(const std::string& name, const std::string& text) override {
    recording_.add_script(name, text);
  }
  void prepare(const ServiceRun& run) override;
  RowSink& rows() override { return tap_; }
  bool operate(RunControl& control) override { return desk_.operate(control); }
  void recording_failed(const std::string& why) override { recording_.fail_log(why); }

  const Endpoint& endpoint() const { return endpoint_; }
  const std::string& token() const { return token_; }

 private:
  void serve(const StopFlag& stop);

  Endpoint endpoint_;
  std::string token_;
  bool wait_ = false;
  Recording recording_;
  Tap tap_{recording_};
  CallDesk calls_{recording_};
  Desk desk_{calls_};
  struct Listening {
    Endpoint endpoint;
    std::string trouble;
  };
  Handover<Listening> listening_;
  std::optional<ServiceThread> thread_;  // last: it uses all of the above
};

/// For a registry.
ServiceType foxglove_service();

}  // namespace trocar::foxglove
