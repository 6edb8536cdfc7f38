// SPDX-License-Identifier: Apache-2.0
#include "plugins/foxglove/server.hpp"

#include <fmt/format.h>

#include <QHostAddress>
#include <QNetworkRequest>
#include <QUrl>
#include <QUrlQuery>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/recording/event_message.hpp"
#include "framework/time_source.hpp"
#include "framework/version.hpp"

namespace trocar::foxglove {
namespace {

constexpr std::size_t most_clients = 64;
constexpr quint64 longest_message = 256 * 1024;  // [B] that a client sends
constexpr std::size_t events_kept = 256;
constexpr std::int64_t state_interval_ns = 200'000'000;
constexpr std::int64_t ping_interval_ns = 5'000'000'000;
constexpr std::int64_t most_silence_ns = 60'000'000'000;  // of a client, though it is pinged
constexpr std::chrono::milliseconds poll_interval{10};
constexpr int records_at_a_time = 20'000;

constexpr const char* state_schema =
    R"({"type":"object","properties":{"run":{"type":"integer"},"running":{"type":"boolean"},)"
    R"("simulated":{"type":"boolean"},"time":{"type":"number"},"log":{"type":"string"},)"
    R"("log_trouble":{"type":"string"},)"
    R"("script":{"type":"string"},"sha256":{"type":"string"},)"
    R"("recording":{"type":"object","properties":{"file":{"type":"string"},)"
    R"("rows":{"type":"integer"},"missed":{"type":"integer"}}},"trouble":{"type":"string"},)"
    R"("stream_missed":{"type":"integer"},"clients":{"type":"integer"}}})";

std::span<const std::byte> as_bytes_of(const QByteArray& bytes) {
  return {reinterpret_cast<const std::byte*>(bytes.data()), static_cast<std::size_t>(bytes.size())};
}

std::string page_of(const QString& origin) {
  const QString host = QUrl(origin).host();
  return origin.isEmpty() ? "" : host.isEmpty() ? "a page" : host.toStdString();
}

}  // namespace

Server::Server(Tap& tap, Desk& desk, CallDesk& calls, Recording& recording, std::string token)
    : tap_(tap),
      desk_(desk),
      calls_(calls),
      recording_(recording),
      token_(std::move(token)),
      socket_("Trocar", QWebSocketServer::NonSecureMode) {
  QStringList protocols;
  for (const char* protocol : stream::subprotocols) protocols << protocol;
  socket_.setSupportedSubprotocols(protocols);
  socket_.setHandshakeTimeout(5000);
  QObject::connect(&socket_, &QWebSocketServer::newConnection, &socket_, [this] { welcome(); });
  QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { poll(); });
  state_channel_ = next_channel_++;
  event_channel_ = next_channel_++;
  advertise_run();
}

Server::~Server() {
  for (auto& [id, client] : clients_) client->socket().disconnect();
}

Endpoint Server::listen(const Endpoint& endpoint) {
  if (!socket_.listen(QHostAddress(QString::fromStdString(endpoint.address)), endpoint.port))
    throw std::runtime_error(fmt::format("nobody can be served at {}: {}", endpoint.url(),
                                         socket_.errorString().toStdString()));
  timer_.start(poll_interval);
  return {endpoint.address, socket_.serverPort()};
}

// --- clients ---

void Server::refuse(QWebSocket& socket, const QString& why) {
  socket.close(QWebSocketProtocol::CloseCodePolicyViolated, why);
  socket.deleteLater();
}

void Server::welcome() {
  while (QWebSocket* socket = socket_.nextPendingConnection()) {
    if (clients_.size() >= most_clients) {
      refuse(*socket, QString("%1 clients are here already").arg(most_clients));
      continue;
    }
    if (socket->subprotocol().isEmpty()) {
      refuse(*socket, "this server speaks foxglove.sdk.v1 and foxglove.websocket.v1");
      continue;
    }
    socket->setMaxAllowedIncomingMessageSize(longest_message);
    socket->setMaxAllowedIncomingFrameSize(longest_message);
    socket->setReadBufferSize(1024 * 1024);
    const Visitor visitor{
        .local = socket->peerAddress().isLoopback(),
        .origin = page_of(socket->origin()),
        .token = QUrlQuery(socket->requestUrl()).queryItemValue("token").toStdString()};
    const std::uint64_t id = next_client_++;
    auto& client = *clients_
                        .emplace(id, std::make_unique<Connection>(id, Connection::Socket(socket),
                                                                  may_write(visitor, token_)))
                        .first->second;
    QObject::connect(socket, &QWebSocket::textMessageReceived, socket,
                     [this, id](const QString& text) { hear_text(id, text); });
    QObject::connect(socket, &QWebSocket::binaryMessageReceived, socket,
                     [this, id](const QByteArray& bytes) { hear_bytes(id, bytes); });
    // Later: a connection may break while clients are gone through.
    QObject::connect(
        socket, &QWebSocket::disconnected, socket, [this, id] { let_go(id); },
        Qt::QueuedConnection);
    QObject::connect(socket, &QWebSocket::pong, socket, [this, id] {
      if (const auto found = clients_.find(id); found != clients_.end())
        found->second->heard(monotonic_ns());
    });
    client.send(
        stream::server_info("Trocar", fmt::format("{}-{}", date_now(), id),
                            {{"trocar", version()}, {"write", client.may_write() ? "yes" : "no"}}));
    if (!client.may_write())
      client.send(stream::status(
          visitor.token.empty() ? stream::StatusLevel::info : stream::StatusLevel::error,
          visitor.token.empty()
              ? "read only, stop works: to change anything add ?token=… to the address"
              : "the token is wrong: read only, stop works",
          "access"));
    client.send(stream::advertise(channels_));
    client.send(stream::advertise_services(offers_));
  }
}

void Server::let_go(std::uint64_t client) {
  clients_.erase(client);
}

void Server::hear_text(std::uint64_t id, const QString& text) {
  if (const auto found = clients_.find(id); found != clients_.end())
    hear(*found->second, [&] { return stream::parse_client_text(text.toStdString()); });
}

void Server::hear_bytes(std::uint64_t id, const QByteArray& bytes) {
  if (const auto found = clients_.find(id); found != clients_.end())
    hear(*found->second, [&] { return stream::parse_client_bytes(as_bytes_of(bytes)); });
}

void Server::hear(Connection& client, const auto& parse) {
  if (client.floods(monotonic_ns())) {
    client.socket().close(QWebSocketProtocol::CloseCodePolicyViolated, "too many messages");
    return;
  }
  try {
    obey(client, parse());
  } catch (const std::invalid_argument& error) {
    client.send(stream::status(stream::StatusLevel::error, error.what()));
  }
}

void Server::obey(Connection& client, stream::ClientMessage message) {
  using namespace stream;
  if (const auto* one = std::get_if<Subscribe>(&message)) return subscribe(client, *one);
  if (const auto* one = std::get_if<Unsubscribe>(&message)) {
    for (const std::uint32_t id : one->ids) client.unsubscribe(id);
    return;
  }
  if (auto* one = std::get_if<GetParameters>(&message)) return ask(client, std::move(*one));
  if (auto* one = std::get_if<SetParameters>(&message)) {
    if (!client.may_write())
      throw std::invalid_argument("to set parameters needs the token: this client only looks");
    return ask(client, std::move(*one));
  }
  if (const auto* one = std::get_if<WatchParameters>(&message))
    return client.watch_parameters(*one);
  if (const auto* one = std::get_if<WatchGraph>(&message)) {
    client.watch_graph(one->on);
    if (one->on && run_) client.send(connection_graph(run_->topics, {}));
    return;
  }
  if (auto* one = std::get_if<CallService>(&message)) return call(client, std::move(*one));
  throw std::invalid_argument(
      fmt::format("\"{}\" is not offered by this server", std::get<NotOffered>(message).op));
}

void Server::subscribe(Connection& client, const stream::Subscribe& message) {
  std::string wrong;
  for (const stream::Subscribe::One& one : message.subscriptions) {
    const std::string trouble = client.subscribe(one, next_channel_ - 1);
    if (!trouble.empty()) wrong += (wrong.empty() ? "" : "; ") + trouble;
    if (trouble.empty() && one.channel == event_channel_)
      for (QByteArray& event : events_) client.send_data(event_channel_, event);
  }
  if (!wrong.empty()) throw std::invalid_argument(wrong);
}

void Server::call(Connection& client, stream::CallService call) {
  const auto fail = [&](const std::string& why) {
    client.send(stream::call_failure(call.service, call.call, why));
  };
  if (call.service == 0 || call.service > offers_.size())
    return fail(fmt::format("there is no service {}", call.service));
  const std::string& name = offers_[call.service - 1].name;
  if (!client.may_write() && !CallDesk::open_to_all(name))
    return fail(fmt::format("to call {} needs the token: this client may look, and stop", name));
  if (!call.encoding.empty() && call.encoding != "json")
    return fail(
        fmt::format("the encoding \"{}\" is not known: json is", call.encoding.substr(0, 60)));
  if (CallDesk::answers_by_itself(name)) {
    calls_.start();
    return client.send(stream::call_response(call.service, call.call, R"({"asked":"start"})"));
  }
  ask(client, Desk::Call{std::move(call), name});
}

void Server::ask(Connection& client, decltype(Desk::Request::what) what) {
  if (!desk_.ask({client.id(), std::move(what), monotonic_ns()}))
    throw std::invalid_argument("too many requests are waiting: this one was dropped");
}

void Server::broadcast(const std::string& text) {
  for (auto& [id, client] : clients_) client->send(text);
}

// --- runs ---

bool Server::wanted(std::uint32_t channel) const {
  for (const auto& [id, client] : clients_)
    if (client->wants(channel)) return true;
  return false;
}

void Server::send(std::uint32_t channel, QByteArray& message) {
  for (auto& [id, client] : clients_) client->send_data(channel, message);
}

void Server::advertise_run() {
  channels_ = {
      {state_channel_, "/trocar/state", "json", "trocar.State", state_schema, "jsonschema"},
      {event_channel_, "/events", "cdr", "trocar/Event", event_schema(), "ros2msg"}};
  for (const ThreadChannels& thread : threads_)
    for (stream::Channel& channel : thread.channels()) channels_.push_back(std::move(channel));
}

void Server::open_next_run() {
  for (std::shared_ptr<StreamRun>& run : tap_.take_runs()) to_come_.push_back(std::move(run));
  if (running_ || to_come_.empty()) return;
  std::vector<std::string> old_topics;
  if (run_)
    for (const stream::Topic& topic : run_->topics) old_topics.push_back(topic.name);
  run_ = std::move(to_come_.front());
  to_come_.pop_front();
  running_ = true;
  time_ns_ = run_->epoch_ns;
  events_.clear();

  std::vector<std::uint32_t> old_channels;
  for (const stream::Channel& channel : channels_)
    if (channel.id > event_channel_) old_channels.push_back(channel.id);
  if (!old_channels.empty()) broadcast(stream::unadvertise(old_channels));
  for (auto& [id, client] : clients_)
    for (const std::uint32_t channel : old_channels) client->forget_channel(channel);
  threads_.clear();
  for (const RowLayout& layout : run_->layouts) {
    threads_.emplace_back(layout, next_channel_, run_->epoch_ns);
    next_channel_ += 3;
  }
  advertise_run();
  broadcast(stream::advertise({channels_.begin() + 2, channels_.end()}));
  for (auto& [id, client] : clients_)
    if (client->watches_graph()) client->send(stream::connection_graph(run_->topics, old_topics));
}

bool Server::take_record() {
  const auto record = run_->cursor.next();
  if (!record) return false;
  missed_ += record->missed;
  const std::size_t group = record->tag >> 2;
  switch (static_cast<TapRecord>(record->tag & 3u)) {
    case TapRecord::row:
      time_ns_ = run_->epoch_ns + static_cast<std::uint64_t>(header_of(record->bytes).time);
      threads_[group].row(
          record->bytes, [this](std::uint32_t channel) { return wanted(channel); },
          [this](std::uint32_t channel, QByteArray& message) { send(channel, message); });
      return true;
    case TapRecord::event:
      remember_event(record->bytes);
      return true;
    case TapRecord::end:
      end_run();
      return false;
  }
  return false;
}

void Server::remember_event(std::span<const std::byte> record) {
  std::int64_t time_ns;
  std::memcpy(&time_ns, record.data(), sizeof time_ns);
  events_.push_back(data_message(run_->epoch_ns + static_cast<std::uint64_t>(time_ns),
                                 record.subspan(sizeof time_ns)));
  if (events_.size() > events_kept) events_.pop_front();
  QByteArray message = events_.back();
  send(event_channel_, message);
}

void Server::end_run() {
  running_ = false;
  for (ThreadChannels& thread : threads_)
    thread.flush(true,
                 [this](std::uint32_t channel, QByteArray& message) { send(channel, message); });
  state_told_ns_ = 0;
}

void Server::poll() {
  open_next_run();
  if (running_)
    for (int i = 0; i < records_at_a_time && take_record(); ++i) {
    }
  for (ThreadChannels& thread : threads_)
    thread.flush(false,
                 [this](std::uint32_t channel, QByteArray& message) { send(channel, message); });
  deliver_answers();
  desk_.refuse_overdue(monotonic_ns());
  tell_state();
  for (auto& [id, client] : clients_) client->look();
}

void Server::deliver_answers() {
  for (const Desk::Answer& answer : desk_.take_answers()) {
    if (const auto found = clients_.find(answer.client); found != clients_.end()) {
      if (!answer.text.empty()) found->second->send(answer.text);
      if (!answer.bytes.empty()) found->second->send(answer.bytes);
    }
    if (answer.changed.empty()) continue;
    for (auto& [id, client] : clients_) {
      std::vector<stream::NamedValue> watched;
      for (const stream::NamedValue& one : answer.changed)
        if (client->watches(one.name)) watched.push_back(one);
      if (!watched.empty()) client->send(stream::parameter_values(watched, ""));
    }
  }
}

/// What is not in the rows: whether there is a run, and what is being recorded.
void Server::tell_state() {
  const std::int64_t now_ns = monotonic_ns();
  if (now_ns - state_told_ns_ < state_interval_ns) return;
  state_told_ns_ = now_ns;
  const std::string trouble = recording_.take_trouble();
  if (!trouble.empty())
    broadcast(stream::status(stream::StatusLevel::error, "recording failed: " + trouble));
  const Recording::State recording = recording_.state();
  const Recording::Mark mark = recording_.mark();
  const double time = run_ ? 1e-9 * static_cast<double>(time_ns_ - run_->epoch_ns) : 0.0;
  const std::string json = nlohmann::ordered_json{
      {"run", run_ ? run_->number : 0},
      {"running", running_},
      {"simulated", run_ && run_->epoch_ns == 0},
      {"time", time_ns_ == 0 ? 0.0 : time},
      {"script", mark.name},
      {"sha256", mark.sha256},
      {"log", run_ ? run_->log : ""},
      {"log_trouble", recording_.log_trouble()},
      {"recording",
       {{"file", recording.file}, {"rows", recording.rows}, {"missed", recording.missed}}},
      {"trouble", trouble},
      {"stream_missed", missed_},
      {"clients",
       clients_.size()}}.dump();
  QByteArray message = data_message(time_ns_ == 0 ? date_now() : time_ns_,
                                    {reinterpret_cast<const std::byte*>(json.data()), json.size()});
  send(state_channel_, message);
  if (running_)
    for (auto& [id, client] : clients_) client->send(stream::time_message(time_ns_));
  if (now_ns - pinged_ns_ < ping_interval_ns) return;
  pinged_ns_ = now_ns;
  for (auto& [id, client] : clients_)
    if (client->silent_for(now_ns) > most_silence_ns)
      client->socket().abort();
    else
      client->socket().ping();
}

}  // namespace trocar::foxglove
