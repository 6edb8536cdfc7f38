// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>
#include <QWebSocket>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "framework/stream/client_message.hpp"

namespace trocar::foxglove {

/// One client. What it does not fetch is not kept for it: beyond a backlog of 4 MiB messages of
/// data are dropped, and it is told how many when it has caught up; one that does not even fetch
/// its answers is let go.
class Connection {
 public:
  struct Deleter {
    void operator()(QWebSocket* socket) const { socket->deleteLater(); }
  };
  using Socket = std::unique_ptr<QWebSocket, Deleter>;

  Connection(std::uint64_t id, Socket socket, bool may_write);

  std::uint64_t id() const { return id_; }
  QWebSocket& socket() { return *socket_; }
  bool may_write() const { return may_write_; }

  void send(const std::string& text);
  void send(std::span<const std::byte> bytes);
  /// A message of data, with its head, to each subscription of the channel.
  void send_data(std::uint32_t channel, QByteArray& message);
  bool wants(std::uint32_t channel) const { return channels_.contains(channel); }

  /// @return what is wrong with it, or ""
  std::string subscribe(const stream::Subscribe::One& one, std::uint32_t newest_channel);
  void unsubscribe(std::uint32_t subscription);
  void forget_channel(std::uint32_t channel);
  void watch_parameters(const stream::WatchParameters& watch);
  bool watches(const std::string& parameter) const;
  void watch_graph(bool on) { watches_graph_ = on; }
  bool watches_graph() const { return watches_graph_; }

  /// It has given a sign of life.
  void heard(std::int64_t now_ns) { heard_ns_ = now_ns; }
  std::int64_t silent_for(std::int64_t now_ns) const { return now_ns - heard_ns_; }
  /// Whether it sends more than anybody needs to.
  bool floods(std::int64_t now_ns);
  /// Tells what was dropped, once it has caught up.
  void look();

 private:
  bool answers_fit();

  static constexpr qint64 backlog = 4 * 1024 * 1024;       // [B] of data
  static constexpr qint64 most_backlog = 8 * 1024 * 1024;  // [B] with answers

  std::uint64_t id_;
  Socket socket_;
  bool may_write_;
  std::map<std::uint32_t, std::uint32_t> subscriptions_;       // channel by subscription
  std::map<std::uint32_t, std::set<std::uint32_t>> channels_;  // subscriptions by channel
  bool watches_all_ = false;
  std::set<std::string> watched_;
  bool watches_graph_ = false;
  std::uint64_t dropped_ = 0;  // and not told
  std::int64_t heard_ns_;
  std::int64_t second_ = 0;
  int in_second_ = 0;
};

}  // namespace trocar::foxglove
