// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <nlohmann/json.hpp>
#include <string>

#include "gui/data/data_store.hpp"
#include "gui/data/stream_state.hpp"
#include "gui/link/stream_client.hpp"

namespace trocar::gui {

/// Fills a store from a live stream, with every row, and asks what else there is to know of a run.
class LiveFeed : public QObject {
  Q_OBJECT

 public:
  struct Limits {
    double seconds = 120.0;                       // of rows that are kept
    std::size_t memory = std::size_t{256} << 20;  // [B] for a thread's rows
  };

  LiveFeed(StreamClient& client, DataStore& store, QObject* parent = nullptr)
      : LiveFeed(client, store, Limits{}, parent) {}
  LiveFeed(StreamClient& client, DataStore& store, Limits limits, QObject* parent = nullptr);

  const StreamState& state() const { return state_; }
  /// docs/log-format.md#graphjson; null until it is known.
  const nlohmann::json& graph() const { return graph_; }
  /// As the service `parameters` gives them; null until they are known.
  const nlohmann::json& parameters() const { return parameters_; }
  void ask_parameters();

 Q_SIGNALS:
  void state_heard();
  void graph_known();
  void parameters_known();
  /// Rows came; at most once for each message.
  void grew();

 private:
  void follow_channels();
  void begin_run();
  void take(const stream::Channel& channel, std::span<const std::byte> bytes);
  void take_rows(const std::string& thread, std::span<const std::byte> bytes);
  void take_state(std::span<const std::byte> bytes);
  void take_event(RunEvent event);
  void ask_graph();
  const stream::Channel* row_channel(const std::string& thread) const;

  StreamClient& client_;
  DataStore& store_;
  Limits limits_;
  StreamState state_;
  nlohmann::json graph_, parameters_;
  std::vector<std::uint32_t> subscribed_;
  bool told_again_ = false;                    // a server tells its newest events to who comes back
  std::vector<stream::Channel> run_channels_;  // of the run whose rows are in the store
};

}  // namespace trocar::gui
