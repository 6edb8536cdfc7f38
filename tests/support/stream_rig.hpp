// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <thread>

#include "framework/session.hpp"
#include "plugins/foxglove/foxglove_service.hpp"
#include "tests/support/run_rig.hpp"
#include "tests/support/stream_client.hpp"

namespace trocar::test {

/// A stream of a meter and a device: fed by hand, or by a run in real time.
struct StreamRig {
  explicit StreamRig(ServiceType::Settings settings = {})
      : service(with_port(std::move(settings))) {}
  ~StreamRig() {
    stop.raise();
    if (loop.joinable()) loop.join();
  }
  StreamRig(const StreamRig&) = delete;
  StreamRig& operator=(const StreamRig&) = delete;

  QString url(const QString& query = {}) const {
    return QString::fromStdString(service.endpoint().url()) + "/" + query;
  }

  // --- by hand ---
  void begin() {
    service.prepare({.virtual_time = true});
    service.rows().begin(layouts, *wired);
  }
  /// A row of that tick at 1 kHz whose other bytes count up from the tick.
  std::vector<std::byte> row(std::int64_t tick) const {
    std::vector<std::byte> row(layouts.front().size());
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = static_cast<std::byte>(static_cast<std::size_t>(tick) + i);
    const RowHeader header{.tick = tick, .time = tick * 1'000'000};
    std::memcpy(row.data(), &header, sizeof header);
    return row;
  }
  void feed(std::int64_t from, std::int64_t to) {
    for (std::int64_t tick = from; tick < to; ++tick) service.rows().row(0, row(tick));
  }
  void end() { service.rows().end(); }

  // --- by a run ---
  /// Until a client calls end.
  void run() {
    loop = std::thread([this] {
      RunOptions options;
      options.sinks = {&service.rows()};
      options.operator_input = [this](RunControl& control) { return service.operate(control); };
      options.keep_rows = true;
      options.stop = &stop;
      service.prepare({.virtual_time = false, .stop = &stop});
      result = trocar::run(rig.graph, options);
    });
  }

  /// The same, of a session with a log of its own.
  void record(const std::string& path) {
    loop = std::thread([this, path] {
      Session session(
          rig.types,
          {.clock = ClockKind::realtime, .record = path, .stop = &stop, .services = {&service}});
      session.graph().add("Meter", "meter", {"test", 1});
      session.graph().add("TestDevice", "arm", {"test", 2});
      session.run({});
      session.finish();
    });
  }

  RunRig rig;
  std::unique_ptr<WiredGraph> wired = wire(rig.graph, {});
  std::vector<RowLayout> layouts = layouts_of(*wired);
  StopFlag stop;
  RunResult result;
  foxglove::FoxgloveService service;
  std::thread loop;  // last: it uses all of the above

 private:
  static ServiceType::Settings with_port(ServiceType::Settings settings) {
    settings.try_emplace("address", "127.0.0.1:0");
    return settings;
  }
};

}  // namespace trocar::test
