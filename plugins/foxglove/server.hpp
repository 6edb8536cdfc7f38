// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWebSocketServer>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "plugins/foxglove/access.hpp"
#include "plugins/foxglove/connection.hpp"
#include "plugins/foxglove/desk.hpp"
#include "plugins/foxglove/tap.hpp"
#include "plugins/foxglove/thread_channels.hpp"

namespace trocar::foxglove {

/// The server of the Foxglove WebSocket protocol, with all its clients, in one thread with an event
/// loop of Qt.
class Server {
 public:
  Server(Tap& tap, Desk& desk, CallDesk& calls, Recording& recording, std::string token);
  ~Server();

  /// @return the endpoint with its port
  /// @throw std::runtime_error when nobody can listen there
  Endpoint listen(const Endpoint& endpoint);
  /// Takes what has come from the runs, and sends it. Qt's event loop does the rest.
  void poll();
  /// How many records the clients' channels were too slow for.
  std::uint64_t missed() const { return missed_; }

 private:
  void welcome();
  void let_go(std::uint64_t client);
  void refuse(QWebSocket& socket, const QString& why);
  void hear_text(std::uint64_t client, const QString& text);
  void hear_bytes(std::uint64_t client, const QByteArray& bytes);
  void hear(Connection& client, const auto& parse);
  void obey(Connection& client, stream::ClientMessage message);
  void subscribe(Connection& client, const stream::Subscribe& message);
  void call(Connection& client, stream::CallService call);
  void ask(Connection& client, decltype(Desk::Request::what) what);

  void open_next_run();
  bool take_record();
  void remember_event(std::span<const std::byte> record);
  void end_run();
  void deliver_answers();
  void tell_state();
  void advertise_run();
  void broadcast(const std::string& text);
  void send(std::uint32_t channel, QByteArray& message);
  bool wanted(std::uint32_t channel) const;

  Tap& tap_;
  Desk& desk_;
  CallDesk& calls_;
  Recording& recording_;
  const std::string token_;
  const std::vector<stream::ServiceOffer> offers_ = CallDesk::offers();
  QWebSocketServer socket_;
  QTimer timer_;
  std::map<std::uint64_t, std::unique_ptr<Connection>> clients_;
  std::uint64_t next_client_ = 1;

  std::deque<std::shared_ptr<StreamRun>> to_come_;
  std::shared_ptr<StreamRun> run_;
  bool running_ = false;
  std::deque<ThreadChannels> threads_;  // of the run
  std::vector<stream::Channel> channels_;
  std::uint32_t next_channel_ = 1;
  std::uint32_t state_channel_ = 0;
  std::uint32_t event_channel_ = 0;
  std::deque<QByteArray> events_;  // the run's newest, for who comes later
  std::uint64_t time_ns_ = 0;      // of the newest row, with the epoch
  std::uint64_t missed_ = 0;
  std::int64_t state_told_ns_ = 0;
  std::int64_t pinged_ns_ = 0;
};

}  // namespace trocar::foxglove
