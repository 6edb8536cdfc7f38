// SPDX-License-Identifier: Apache-2.0
#include "plugins/foxglove/connection.hpp"

#include <fmt/format.h>

#include <utility>

#include "framework/time_source.hpp"

namespace trocar::foxglove {
namespace {

constexpr std::size_t most_subscriptions = 1000;
constexpr std::size_t most_watched = 10000;
constexpr int most_messages = 500;  // a second

}  // namespace

Connection::Connection(std::uint64_t id, Socket socket, bool may_write)
    : id_(id), socket_(std::move(socket)), may_write_(may_write), heard_ns_(monotonic_ns()) {}

bool Connection::answers_fit() {
  if (socket_->bytesToWrite() <= most_backlog) return true;
  socket_->abort();
  return false;
}

void Connection::send(const std::string& text) {
  if (answers_fit()) socket_->sendTextMessage(QString::fromStdString(text));
}

void Connection::send(std::span<const std::byte> bytes) {
  if (answers_fit())
    socket_->sendBinaryMessage(QByteArray(reinterpret_cast<const char*>(bytes.data()),
                                          static_cast<qsizetype>(bytes.size())));
}

void Connection::send_data(std::uint32_t channel, QByteArray& message) {
  const auto found = channels_.find(channel);
  if (found == channels_.end()) return;
  for (const std::uint32_t subscription : found->second) {
    if (socket_->bytesToWrite() > backlog) {
      ++dropped_;
      continue;
    }
    stream::set_subscription(
        {reinterpret_cast<std::byte*>(message.data()), static_cast<std::size_t>(message.size())},
        subscription);
    socket_->sendBinaryMessage(message);
  }
}

std::string Connection::subscribe(const stream::Subscribe::One& one, std::uint32_t newest_channel) {
  if (one.channel == 0 || one.channel > newest_channel)
    return fmt::format("there is no channel {}", one.channel);
  if (subscriptions_.size() >= most_subscriptions)
    return fmt::format("at most {} subscriptions are taken", most_subscriptions);
  if (!subscriptions_.emplace(one.id, one.channel).second)
    return fmt::format("there is a subscription {} already", one.id);
  channels_[one.channel].insert(one.id);
  return "";
}

void Connection::unsubscribe(std::uint32_t subscription) {
  const auto found = subscriptions_.find(subscription);
  if (found == subscriptions_.end()) return;
  const auto channel = channels_.find(found->second);
  channel->second.erase(subscription);
  if (channel->second.empty()) channels_.erase(channel);
  subscriptions_.erase(found);
}

void Connection::forget_channel(std::uint32_t channel) {
  const auto found = channels_.find(channel);
  if (found == channels_.end()) return;
  for (const std::uint32_t subscription : found->second) subscriptions_.erase(subscription);
  channels_.erase(found);
}

void Connection::watch_parameters(const stream::WatchParameters& watch) {
  if (watch.names.empty()) {
    watches_all_ = watch.on;
    if (!watch.on) watched_.clear();
  }
  for (const std::string& name : watch.names)
    if (!watch.on)
      watched_.erase(name);
    else if (watched_.size() < most_watched)
      watched_.insert(name);
}

bool Connection::watches(const std::string& parameter) const {
  return watches_all_ || watched_.contains(parameter);
}

bool Connection::floods(std::int64_t now_ns) {
  const std::int64_t second = now_ns / 1'000'000'000;
  if (std::exchange(second_, second) != second) in_second_ = 0;
  return ++in_second_ > most_messages;
}

void Connection::look() {
  if (dropped_ == 0 || socket_->bytesToWrite() > backlog / 2) return;
  send(stream::status(stream::StatusLevel::warning,
                      fmt::format("{} messages were dropped: this client fetched them too slowly. "
                                  "The loop and its log lost nothing.",
                                  dropped_),
                      "dropped"));
  dropped_ = 0;
}

}  // namespace trocar::foxglove
