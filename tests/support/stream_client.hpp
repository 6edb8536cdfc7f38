// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QNetworkRequest>
#include <QTest>
#include <QUrl>
#include <QWebSocket>
#include <QWebSocketHandshakeOptions>
#include <cstring>
#include <map>
#include <vector>

#include "framework/stream/client_message.hpp"

namespace trocar::test {

/// A client of the stream that remembers all it is told.
class StreamClient {
 public:
  explicit StreamClient(const QString& url, const QString& origin = {},
                        const QString& protocol = "foxglove.sdk.v1")
      : socket_(origin) {
    QObject::connect(&socket_, &QWebSocket::textMessageReceived, &socket_,
                     [this](const QString& text) {
                       texts.push_back(QJsonDocument::fromJson(text.toUtf8()).object());
                     });
    QObject::connect(&socket_, &QWebSocket::binaryMessageReceived, &socket_,
                     [this](const QByteArray& bytes) { hear(bytes); });
    QWebSocketHandshakeOptions options;
    if (!protocol.isEmpty()) options.setSubprotocols({protocol});
    socket_.open(QNetworkRequest(QUrl(url)), options);
  }

  QWebSocket& socket() { return socket_; }
  bool open() {
    return wait([&] { return socket_.state() == QAbstractSocket::ConnectedState; });
  }
  bool closed() {
    return wait([&] { return socket_.state() == QAbstractSocket::UnconnectedState; });
  }
  static bool wait(const std::function<bool()>& until) { return QTest::qWaitFor(until, 10'000); }

  QJsonObject last(const QString& op) const {
    for (auto one = texts.rbegin(); one != texts.rend(); ++one)
      if ((*one)["op"] == op) return *one;
    return {};
  }
  /// What was told as status, one line each.
  QString statuses() const {
    QStringList lines;
    for (const QJsonObject& one : texts)
      if (one["op"] == "status") lines << one["message"].toString();
    return lines.join('\n');
  }
  QJsonObject channel(const QString& topic) const {
    QJsonObject found;
    for (const QJsonObject& one : texts)
      if (one["op"] == "advertise")
        for (const QJsonValue& channel : one["channels"].toArray())
          if (channel["topic"] == topic) found = channel.toObject();
    return found;
  }
  bool subscribe(const QString& topic, std::uint32_t id) {
    if (!wait([&] { return !channel(topic).isEmpty(); })) return false;
    const auto number = static_cast<std::uint32_t>(channel(topic)["id"].toInt());
    send(stream::subscribe_text({.subscriptions = {{.id = id, .channel = number}}}));
    return true;
  }
  void send(const std::string& text) { socket_.sendTextMessage(QString::fromStdString(text)); }

  /// The newest message of a subscription to JSON.
  QJsonObject json(std::uint32_t id) const {
    const auto found = messages.find(id);
    if (found == messages.end() || found->second.empty()) return {};
    return QJsonDocument::fromJson(found->second.back().content).object();
  }

  /// @return the service's answer, or {"failure": why}
  QJsonObject call(const QString& service, const QByteArray& arguments = "{}") {
    wait([&] { return !last("advertiseServices").isEmpty(); });
    std::uint32_t id = 0;
    for (const QJsonValue& one : last("advertiseServices")["services"].toArray())
      if (one["name"] == service) id = static_cast<std::uint32_t>(one["id"].toInt());
    const std::uint32_t number = ++calls_;
    const std::vector<std::byte> bytes = stream::call_bytes(
        {.service = id, .call = number, .encoding = "json", .payload = arguments.toStdString()});
    socket_.sendBinaryMessage(QByteArray(reinterpret_cast<const char*>(bytes.data()),
                                         static_cast<qsizetype>(bytes.size())));
    QJsonObject answer;
    wait([&] {
      if (const auto found = answers_.find(number); found != answers_.end()) {
        answer = QJsonDocument::fromJson(found->second).object();
        return true;
      }
      for (const QJsonObject& one : texts)
        if (one["op"] == "serviceCallFailure" &&
            one["callId"].toInt() == static_cast<int>(number)) {
          answer = {{"failure", one["message"]}};
          return true;
        }
      return false;
    });
    return answer;
  }

  struct Message {
    std::uint64_t time_ns;
    QByteArray content;
    std::span<const std::byte> bytes() const {
      return {reinterpret_cast<const std::byte*>(content.data()),
              static_cast<std::size_t>(content.size())};
    }
  };
  std::vector<QJsonObject> texts;
  std::map<std::uint32_t, std::vector<Message>> messages;  // by subscription
  std::uint64_t time_ns = 0;

 private:
  template <typename Number>
  static Number number(const QByteArray& bytes, qsizetype offset) {
    Number number;
    std::memcpy(&number, bytes.data() + offset, sizeof number);
    return number;
  }
  void hear(const QByteArray& bytes) {
    if (bytes[0] == 1)
      messages[number<std::uint32_t>(bytes, 1)].push_back(
          {number<std::uint64_t>(bytes, 5), bytes.mid(13)});
    else if (bytes[0] == 2)
      time_ns = number<std::uint64_t>(bytes, 1);
    else if (bytes[0] == 3)
      answers_[number<std::uint32_t>(bytes, 5)] =
          bytes.mid(13 + static_cast<qsizetype>(number<std::uint32_t>(bytes, 9)));
  }

  QWebSocket socket_;
  std::uint32_t calls_ = 0;
  std::map<std::uint32_t, QByteArray> answers_;
};

}  // namespace trocar::test
