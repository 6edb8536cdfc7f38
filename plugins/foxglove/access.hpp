// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trocar::foxglove {

/// Where the server listens.
struct Endpoint {
  std::string address = "127.0.0.1";  // numeric, IPv4 or IPv6
  std::uint16_t port = 8765;          // 0: any that is free

  bool loopback() const;
  std::string url() const;
};

/// Reads "", "9000", ":9000", "0.0.0.0", "127.0.0.1:9000", "[::1]:9000", "localhost:9000".
/// @throw std::invalid_argument
Endpoint parse_endpoint(std::string_view text);

/// A client, as its connection shows it.
struct Visitor {
  bool local = false;    // from this machine
  std::string origin{};  // of the page, where it is a browser's; else ""
  std::string token{};   // ?token= of the URL
};

/// Who may change anything: whoever knows the token, and programs on this machine. A browser's page
/// needs the token here too, since any page that the user looks at could connect. To look, and to
/// stop, nobody needs it.
bool may_write(const Visitor& visitor, std::string_view token);

/// 128 random bits in hexadecimal.
std::string random_token();

}  // namespace trocar::foxglove
