// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <QUrl>
#include <QWebSocket>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "framework/stream/parse_server_message.hpp"

namespace trocar::gui {

enum class LinkState { closed, connecting, open, silent };
const char* to_string(LinkState state);

/// A client of a live stream (docs/stream.md). It connects anew when the connection breaks, and
/// says after half a second without a sign of life that it hears nothing. It never asks for
/// anything by itself but signs of life: connecting again engages nothing.
class StreamClient : public QObject {
  Q_OBJECT

 public:
  /// What became of a call: its answer, or why there is none.
  using Answer = std::function<void(const nlohmann::json& answer, const std::string& trouble)>;

  static constexpr int silent_after_ms = 500;

  explicit StreamClient(QObject* parent = nullptr);
  ~StreamClient() override;

  /// @param url ws://ADDRESS:PORT, with ?token=… to change something on another machine
  void open(const QUrl& url);
  void close();
  const QUrl& url() const { return url_; }
  LinkState state() const { return state_; }
  const std::string& why() const { return why_; }  // it is not open
  /// [ms] to the server and back, of the last sign of life; negative when there was none.
  double round_trip_ms() const { return round_trip_ms_; }
  const stream::ServerInfo& server() const { return server_; }
  bool may_write() const;

  const std::map<std::uint32_t, stream::Channel>& channels() const { return channels_; }
  void subscribe(std::uint32_t channel);
  void unsubscribe(std::uint32_t channel);

  bool offers(const std::string& service) const { return services_.count(service) > 0; }
  /// The answer comes later, exactly once; at once when there is no such service.
  void call(const std::string& service, const nlohmann::json& arguments = nlohmann::json::object(),
            Answer answer = {});
  void get_parameters(const std::vector<std::string>& names = {});
  void set_parameter(const std::string& name, const stream::ParameterValue& value);
  void watch_parameters();  // all

 Q_SIGNALS:
  void state_changed();
  void channels_changed();
  void services_changed();
  /// The bytes are valid during the call.
  void message(const trocar::stream::Channel& channel, quint64 time_ns,
               std::span<const std::byte> bytes);
  void status(const trocar::stream::Status& status);
  void parameters(const std::vector<trocar::stream::NamedValue>& values);

 private:
  void connect_socket();
  void begin();
  void end(const QString& why);
  void look();
  void heard();
  void hear_text(const QString& text);
  void hear_bytes(const QByteArray& bytes);
  void take(stream::ServerText message);
  void settle(std::uint32_t call, const nlohmann::json& answer, const std::string& trouble);
  void settle_all(const std::string& trouble);
  void set_state(LinkState state, const std::string& why);
  void send(const std::string& text);

  QUrl url_;
  QWebSocket socket_;
  QTimer look_, again_;
  QElapsedTimer last_heard_;
  LinkState state_ = LinkState::closed;
  std::string why_;
  double round_trip_ms_ = -1.0;
  stream::ServerInfo server_;
  std::map<std::uint32_t, stream::Channel> channels_;
  std::map<std::string, std::uint32_t> services_;
  std::map<std::uint32_t, Answer> calls_;
  std::uint32_t next_call_ = 1;
};

}  // namespace trocar::gui
