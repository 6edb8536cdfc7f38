// SPDX-License-Identifier: Apache-2.0
#include "framework/stream/message_json.hpp"

#include <fmt/format.h>

#include <limits>

namespace trocar::stream {

MessageJson parsed_message(std::string_view text) {
  MessageJson json = MessageJson::parse(text, nullptr, false);
  if (json.is_discarded()) throw std::invalid_argument("a message is not JSON");
  if (!json.is_object()) throw std::invalid_argument("a message needs to be a JSON object");
  return json;
}

const MessageJson& member(const MessageJson& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) throw std::invalid_argument(fmt::format("\"{}\" is missing", key));
  return *found;
}

const MessageJson& list_of(const MessageJson& object, const char* key) {
  const MessageJson& list = member(object, key);
  if (!list.is_array()) throw std::invalid_argument(fmt::format("\"{}\" needs a list", key));
  return list;
}

std::uint32_t id_of(const MessageJson& json, const char* key) {
  if (!json.is_number_unsigned() ||
      json.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument(fmt::format("\"{}\" needs a whole number of 32 bits", key));
  return json.get<std::uint32_t>();
}

std::string text_of(const MessageJson& json, const char* key) {
  if (!json.is_string()) throw std::invalid_argument(fmt::format("\"{}\" needs a text", key));
  return json.get<std::string>();
}

std::string optional_text(const MessageJson& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? "" : text_of(*found, key);
}

std::vector<std::string> names_of(const MessageJson& object, const char* key) {
  std::vector<std::string> names;
  for (const MessageJson& one : list_of(object, key)) names.push_back(text_of(one, key));
  return names;
}

ParameterValue value_of(const MessageJson& json) {
  if (json.is_number()) return json.get<double>();
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_string()) return json.get<std::string>();
  if (!json.is_array())
    throw std::invalid_argument(
        "\"value\" needs a number, a list of numbers, a text, true or false");
  std::vector<double> numbers;
  for (const MessageJson& one : json) {
    if (!one.is_number()) throw std::invalid_argument("\"value\" is a list, but not of numbers");
    numbers.push_back(one.get<double>());
  }
  return numbers;
}

std::vector<NamedValue> values_of(const MessageJson& object) {
  std::vector<NamedValue> values;
  for (const MessageJson& one : list_of(object, "parameters")) {
    if (!one.is_object()) throw std::invalid_argument("\"parameters\" needs a list of objects");
    values.push_back({text_of(member(one, "name"), "name"), value_of(member(one, "value"))});
  }
  return values;
}

MessageJson value_json(const ParameterValue& value) {
  return std::visit(
      [](const auto& one) -> MessageJson {
        if constexpr (std::is_same_v<std::decay_t<decltype(one)>, std::monostate>)
          return nullptr;
        else
          return one;
      },
      value);
}

std::string take_text(std::span<const std::byte>& bytes, const char* what) {
  const auto length = take<std::uint32_t>(bytes);
  if (length > bytes.size())
    throw std::invalid_argument(fmt::format("{} is shorter than it says", what));
  std::string text = as_text(bytes.first(length));
  bytes = bytes.subspan(length);
  return text;
}

std::string as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace trocar::stream
