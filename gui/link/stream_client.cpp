// SPDX-License-Identifier: Apache-2.0
#include "gui/link/stream_client.hpp"

#include <QNetworkRequest>
#include <stdexcept>

#include "framework/stream/client_message.hpp"

namespace trocar::gui {
namespace {

constexpr int look_interval_ms = 100;
constexpr int again_interval_ms = 500;
constexpr quint64 longest_message = 64 * 1024 * 1024;  // [B] that a server sends

}  // namespace

const char* to_string(LinkState state) {
  switch (state) {
    case LinkState::closed:
      return "closed";
    case LinkState::connecting:
      return "connecting";
    case LinkState::open:
      return "open";
    case LinkState::silent:
      return "silent";
  }
  return "?";
}

StreamClient::StreamClient(QObject* parent) : QObject(parent) {
  socket_.setMaxAllowedIncomingMessageSize(longest_message);
  socket_.setMaxAllowedIncomingFrameSize(longest_message);
  connect(&socket_, &QWebSocket::connected, this, &StreamClient::begin);
  connect(&socket_, &QWebSocket::disconnected, this, [this] {
    const QString said = socket_.closeReason();
    end(said.isEmpty() ? "the connection ended" : said);
  });
  connect(&socket_, qOverload<QAbstractSocket::SocketError>(&QWebSocket::error), this,
          [this] { end(socket_.errorString()); });
  connect(&socket_, &QWebSocket::pong, this, [this](quint64 elapsed_ms) {
    round_trip_ms_ = static_cast<double>(elapsed_ms);
    heard();
  });
  connect(&socket_, &QWebSocket::textMessageReceived, this, &StreamClient::hear_text);
  connect(&socket_, &QWebSocket::binaryMessageReceived, this, &StreamClient::hear_bytes);
  connect(&look_, &QTimer::timeout, this, &StreamClient::look);
  again_.setSingleShot(true);
  connect(&again_, &QTimer::timeout, this, &StreamClient::connect_socket);
}

// The socket is among the last to go, and says then that it ended.
StreamClient::~StreamClient() {
  socket_.disconnect(this);
}

void StreamClient::open(const QUrl& url) {
  close();
  url_ = url;
  set_state(LinkState::connecting, "connecting");
  connect_socket();
}

void StreamClient::close() {
  again_.stop();
  url_.clear();
  if (socket_.state() != QAbstractSocket::UnconnectedState) socket_.abort();
  end("closed");
}

void StreamClient::connect_socket() {
  if (url_.isEmpty()) return;
  QNetworkRequest request(url_);
  // QWebSocket of Qt 6.4 offers subprotocols only by the header itself.
  request.setRawHeader("Sec-WebSocket-Protocol", stream::subprotocols[0]);
  socket_.open(request);
}

void StreamClient::begin() {
  round_trip_ms_ = -1.0;
  look_.start(look_interval_ms);
  heard();
}

void StreamClient::end(const QString& why) {
  look_.stop();
  round_trip_ms_ = -1.0;
  const bool had_channels = !channels_.empty();
  channels_.clear();
  services_.clear();
  settle_all(why.toStdString());
  if (had_channels) Q_EMIT channels_changed();
  set_state(url_.isEmpty() ? LinkState::closed : LinkState::connecting, why.toStdString());
  if (!url_.isEmpty() && !again_.isActive()) again_.start(again_interval_ms);
}

void StreamClient::look() {
  if (last_heard_.elapsed() > silent_after_ms)
    set_state(LinkState::silent, "nothing is heard from the other side");
  socket_.ping();
}

void StreamClient::heard() {
  last_heard_.start();
  set_state(LinkState::open, "");
}

void StreamClient::set_state(LinkState state, const std::string& why) {
  if (state == state_ && why == why_) return;
  state_ = state;
  why_ = why;
  Q_EMIT state_changed();
}

bool StreamClient::may_write() const {
  const auto found = server_.metadata.find("write");
  return found != server_.metadata.end() && found->second == "yes";
}

void StreamClient::send(const std::string& text) {
  socket_.sendTextMessage(QString::fromStdString(text));
}

// Subscriptions have their channel's number.
void StreamClient::subscribe(std::uint32_t channel) {
  send(stream::subscribe_text({.subscriptions = {{.id = channel, .channel = channel}}}));
}

void StreamClient::unsubscribe(std::uint32_t channel) {
  send(stream::unsubscribe_text({.ids = {channel}}));
}

void StreamClient::call(const std::string& service, const nlohmann::json& arguments,
                        Answer answer) {
  const auto found = services_.find(service);
  if (found == services_.end()) {
    if (answer)
      answer({}, services_.empty() ? "there is no connection"
                                   : "the other side has no service \"" + service + "\"");
    return;
  }
  const std::uint32_t id = next_call_++;
  calls_[id] = std::move(answer);
  const std::vector<std::byte> bytes = stream::call_bytes(
      {.service = found->second, .call = id, .encoding = "json", .payload = arguments.dump()});
  socket_.sendBinaryMessage(QByteArray(reinterpret_cast<const char*>(bytes.data()),
                                       static_cast<qsizetype>(bytes.size())));
}

void StreamClient::get_parameters(const std::vector<std::string>& names) {
  send(stream::get_parameters_text({.names = names, .id = {}}));
}

void StreamClient::set_parameter(const std::string& name, const stream::ParameterValue& value) {
  send(stream::set_parameters_text({.values = {{name, value}}, .id = name}));
}

void StreamClient::watch_parameters() {
  send(stream::watch_parameters_text({.names = {}, .on = true}));
}

void StreamClient::hear_text(const QString& text) {
  heard();
  try {
    take(stream::parse_server_text(text.toStdString()));
  } catch (const std::invalid_argument& error) {
    Q_EMIT status(
        {.level = stream::StatusLevel::warning,
         .text = std::string("the other side said what is not understood: ") + error.what(),
         .id = {}});
  }
}

void StreamClient::take(stream::ServerText text) {
  if (auto* info = std::get_if<stream::ServerInfo>(&text)) {
    server_ = std::move(*info);
    Q_EMIT state_changed();
  } else if (auto* advertise = std::get_if<stream::Advertise>(&text)) {
    for (stream::Channel& channel : advertise->channels) channels_[channel.id] = std::move(channel);
    Q_EMIT channels_changed();
  } else if (const auto* withdrawn = std::get_if<stream::Unadvertise>(&text)) {
    for (const std::uint32_t id : withdrawn->ids) channels_.erase(id);
    Q_EMIT channels_changed();
  } else if (const auto* offers = std::get_if<stream::AdvertiseServices>(&text)) {
    for (const stream::ServiceOffer& one : offers->services) services_[one.name] = one.id;
    Q_EMIT services_changed();
  } else if (const auto* one = std::get_if<stream::Status>(&text)) {
    Q_EMIT status(*one);
  } else if (const auto* values = std::get_if<stream::ParameterValues>(&text)) {
    Q_EMIT parameters(values->values);
  } else if (const auto* failure = std::get_if<stream::CallFailure>(&text)) {
    settle(failure->call, {}, failure->text);
  }
}

void StreamClient::hear_bytes(const QByteArray& bytes) {
  heard();
  try {
    const stream::ServerBytes parsed = stream::parse_server_bytes(
        {reinterpret_cast<const std::byte*>(bytes.data()), static_cast<std::size_t>(bytes.size())});
    if (const auto* data = std::get_if<stream::Data>(&parsed)) {
      if (const auto channel = channels_.find(data->subscription); channel != channels_.end())
        Q_EMIT message(channel->second, data->time_ns, data->bytes);
    } else if (const auto* response = std::get_if<stream::CallResponse>(&parsed)) {
      const nlohmann::json answer = nlohmann::json::parse(response->payload, nullptr, false);
      settle(response->call, answer,
             answer.is_discarded() ? "the answer to a call is not JSON" : std::string());
    }
  } catch (const std::exception& error) {
    Q_EMIT status({.level = stream::StatusLevel::warning,
                   .text = std::string("a message is not understood: ") + error.what(),
                   .id = {}});
  }
}

void StreamClient::settle(std::uint32_t call, const nlohmann::json& answer,
                          const std::string& trouble) {
  const auto found = calls_.find(call);
  if (found == calls_.end()) return;
  const Answer tell = std::move(found->second);
  calls_.erase(found);
  if (tell) tell(answer, trouble);
}

void StreamClient::settle_all(const std::string& trouble) {
  while (!calls_.empty()) settle(calls_.begin()->first, {}, trouble);
}

}  // namespace trocar::gui
