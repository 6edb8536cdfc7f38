// SPDX-License-Identifier: Apache-2.0
#include "plugins/foxglove/access.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>

#include <charconv>
#include <random>
#include <stdexcept>

namespace trocar::foxglove {
namespace {

[[noreturn]] void refuse_endpoint(std::string_view text) {
  throw std::invalid_argument(fmt::format(
      "\"{}\" is no address to listen at: needs ADDR, PORT or ADDR:PORT, e.g. 127.0.0.1:8765; "
      "0.0.0.0 lets other machines in",
      text));
}

std::uint16_t port_of(std::string_view text, std::string_view whole) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size())
    refuse_endpoint(whole);
  return port;
}

bool all_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Takes the same time however much of it is right.
bool same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  return difference == 0;
}

}  // namespace

bool Endpoint::loopback() const {
  return address == "::1" || address.starts_with("127.");
}

std::string Endpoint::url() const {
  return address.find(':') == std::string::npos ? fmt::format("ws://{}:{}", address, port)
                                                : fmt::format("ws://[{}]:{}", address, port);
}

Endpoint parse_endpoint(std::string_view text) {
  Endpoint endpoint;
  std::string_view address = text, port;
  if (text.starts_with('[')) {
    const std::size_t close = text.find(']');
    if (close == std::string_view::npos) refuse_endpoint(text);
    address = text.substr(1, close - 1);
    port = text.substr(close + 1);
    if (!port.empty() && !port.starts_with(':')) refuse_endpoint(text);
    if (!port.empty()) endpoint.port = port_of(port.substr(1), text);
  } else if (all_digits(text)) {
    endpoint.port = port_of(text, text);
    address = {};
  } else if (const std::size_t colon = text.rfind(':'); colon != std::string_view::npos) {
    endpoint.port = port_of(text.substr(colon + 1), text);
    address = text.substr(0, colon);
  }
  if (address == "localhost") address = "127.0.0.1";
  if (!address.empty()) endpoint.address = address;
  // What is no address must not become "all of them".
  in6_addr ignored;
  if (inet_pton(AF_INET, endpoint.address.c_str(), &ignored) != 1 &&
      inet_pton(AF_INET6, endpoint.address.c_str(), &ignored) != 1)
    refuse_endpoint(text);
  return endpoint;
}

bool may_write(const Visitor& visitor, std::string_view token) {
  if (!token.empty() && same_secret(visitor.token, token)) return true;
  return visitor.local && visitor.origin.empty() && visitor.token.empty();
}

std::string random_token() {
  std::random_device device;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", device());
  return token;
}

}  // namespace trocar::foxglove
