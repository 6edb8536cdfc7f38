// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "framework/realtime/mailbox.hpp"
#include "framework/recording/row_sink.hpp"
#include "framework/service.hpp"
#include "plugins/foxglove/recording.hpp"
#include "plugins/foxglove/stream_run.hpp"

namespace trocar::foxglove {

/// Reads the rows of each run, and lays them where the server takes them when it has time. A
/// server that is too slow loses the oldest; nobody waits for it.
class Tap final : public RowSink {
 public:
  explicit Tap(Recording& recording) : recording_(recording) {}

  void prepare(const ServiceRun& run) { next_ = run; }
  std::string_view reader_name() const override { return "stream"; }
  bool needs_every_row() const override { return false; }
  void begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) override;
  void row(std::size_t group, std::span<const std::byte> row) override;
  void event(std::size_t group, const Event& event) override;
  void missed(std::uint64_t records) override { recording_.missed(records); }
  void end() override;

  /// Runs that have begun since the last call, for the server. Of very many short ones the newest.
  std::deque<std::shared_ptr<StreamRun>> take_runs() { return runs_.take_all(); }

 private:
  void write(TapRecord kind, std::size_t group, std::span<const std::byte> bytes);

  Recording& recording_;
  ServiceRun next_;
  std::shared_ptr<StreamRun> run_;
  std::vector<std::byte> message_, record_;  // of an event
  int number_ = 0;
  Mailbox<std::shared_ptr<StreamRun>> runs_{8};
};

/// [ns] since 1970.
std::uint64_t date_now();

}  // namespace trocar::foxglove
