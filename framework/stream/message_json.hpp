// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "framework/stream/server_message.hpp"

/// @file
/// Pieces of messages of the Foxglove WebSocket protocol, for both sides. What was sent by anybody
/// and does not fit throws std::invalid_argument with what is wrong.

namespace trocar::stream {

/// Not the ordered one, in which an object of many keys takes quadratic time.
using MessageJson = nlohmann::json;

/// What a message is, as JSON. @throw when it is not an object.
MessageJson parsed_message(std::string_view text);

const MessageJson& member(const MessageJson& object, const char* key);
const MessageJson& list_of(const MessageJson& object, const char* key);
std::uint32_t id_of(const MessageJson& json, const char* key);
std::string text_of(const MessageJson& json, const char* key);
std::string optional_text(const MessageJson& object, const char* key);
std::vector<std::string> names_of(const MessageJson& object, const char* key);
ParameterValue value_of(const MessageJson& json);
std::vector<NamedValue> values_of(const MessageJson& object);

MessageJson value_json(const ParameterValue& value);

/// Takes a number from the front of a binary message.
template <typename Number>
Number take(std::span<const std::byte>& bytes) {
  if (bytes.size() < sizeof(Number)) throw std::invalid_argument("a binary message is too short");
  Number number;
  std::memcpy(&number, bytes.data(), sizeof number);
  bytes = bytes.subspan(sizeof number);
  return number;
}

/// Takes a text with its length in front.
std::string take_text(std::span<const std::byte>& bytes, const char* what);

std::string as_text(std::span<const std::byte> bytes);

}  // namespace trocar::stream
