// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/stream_messages.hpp"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "framework/stream/client_message.hpp"
#include "framework/stream/parse_server_message.hpp"

namespace trocar::test {
namespace {

using namespace trocar::stream;

void promise(bool kept) {
  if (!kept) std::abort();
}

std::string_view as_text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Numbers beyond double's range are infinite, and JSON has none to write.
bool finite(const SetParameters& set) {
  for (const NamedValue& one : set.values) {
    if (const auto* number = std::get_if<double>(&one.value); number && !std::isfinite(*number))
      return false;
    if (const auto* numbers = std::get_if<std::vector<double>>(&one.value))
      for (const double number : *numbers)
        if (!std::isfinite(number)) return false;
  }
  return true;
}

template <typename Message>
Message again(const std::string& text) {
  return std::get<Message>(parse_client_text(text));
}

void check_again(const Subscribe& message) {
  const auto other = again<Subscribe>(subscribe_text(message));
  promise(other.subscriptions.size() == message.subscriptions.size());
  for (std::size_t i = 0; i < other.subscriptions.size(); ++i)
    promise(other.subscriptions[i].id == message.subscriptions[i].id &&
            other.subscriptions[i].channel == message.subscriptions[i].channel);
}
void check_again(const Unsubscribe& message) {
  promise(again<Unsubscribe>(unsubscribe_text(message)).ids == message.ids);
}
void check_again(const GetParameters& message) {
  const auto other = again<GetParameters>(get_parameters_text(message));
  promise(other.names == message.names && other.id == message.id);
}
void check_again(const SetParameters& message) {
  if (!finite(message)) return;
  const auto other = again<SetParameters>(set_parameters_text(message));
  promise(other.id == message.id && other.values.size() == message.values.size());
  for (std::size_t i = 0; i < other.values.size(); ++i)
    promise(other.values[i].name == message.values[i].name &&
            other.values[i].value == message.values[i].value);
}
void check_again(const WatchParameters& message) {
  const auto other = again<WatchParameters>(watch_parameters_text(message));
  promise(other.names == message.names && other.on == message.on);
}
void check_again(const WatchGraph& message) {
  promise(again<WatchGraph>(watch_graph_text(message)).on == message.on);
}
void check_again(const CallService& message) {
  const auto other = std::get<CallService>(parse_client_bytes(call_bytes(message)));
  promise(other.service == message.service && other.call == message.call &&
          other.encoding == message.encoding && other.payload == message.payload);
}
void check_again(const NotOffered& message) {
  promise(!message.op.empty());
}

void check_again(const Advertise& message) {
  const auto other = std::get<Advertise>(parse_server_text(advertise(message.channels)));
  promise(other.channels.size() == message.channels.size());
  for (std::size_t i = 0; i < other.channels.size(); ++i)
    promise(other.channels[i].id == message.channels[i].id &&
            other.channels[i].topic == message.channels[i].topic &&
            other.channels[i].schema == message.channels[i].schema);
}
void check_again(const Unadvertise& message) {
  promise(std::get<Unadvertise>(parse_server_text(unadvertise(message.ids))).ids == message.ids);
}
void check_again(const Status& message) {
  const auto other =
      std::get<Status>(parse_server_text(status(message.level, message.text, message.id)));
  promise(other.level == message.level && other.text == message.text && other.id == message.id);
}
void check_again(const CallFailure& message) {
  const auto other = std::get<CallFailure>(
      parse_server_text(call_failure(message.service, message.call, message.text)));
  promise(other.service == message.service && other.call == message.call &&
          other.text == message.text);
}
void check_again(const CallResponse& message) {
  if (message.encoding != "json") return;
  const std::vector<std::byte> bytes =
      call_response(message.service, message.call, message.payload);
  const auto other = std::get<CallResponse>(parse_server_bytes(bytes));
  promise(other.service == message.service && other.call == message.call &&
          other.payload == message.payload);
}
void check_again(const auto&) {}  // not written by us in that form

void feed_client(std::span<const std::uint8_t> message, bool text) {
  const ClientMessage read =
      text ? parse_client_text(as_text(message)) : parse_client_bytes(std::as_bytes(message));
  std::visit([](const auto& one) { check_again(one); }, read);
}

void feed_server(std::span<const std::uint8_t> message, bool text) {
  if (text)
    std::visit([](const auto& one) { check_again(one); }, parse_server_text(as_text(message)));
  else
    std::visit([](const auto& one) { check_again(one); },
               parse_server_bytes(std::as_bytes(message)));
}

}  // namespace

bool feed_stream_message(std::span<const std::uint8_t> input) {
  if (input.empty()) return false;
  const bool text = (input[0] & 1) != 0, server = (input[0] & 2) != 0;
  try {
    (server ? feed_server : feed_client)(input.subspan(1), text);
  } catch (const std::invalid_argument& error) {
    promise(*error.what() != 0);
    return false;
  }
  return true;
}

}  // namespace trocar::test
