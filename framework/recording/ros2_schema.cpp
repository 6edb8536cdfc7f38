// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/ros2_schema.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace trocar {
namespace {

constexpr std::size_t max_name = 255;
constexpr int max_depth = 32;

[[noreturn]] void refuse_schema(const std::string& text) {
  throw std::invalid_argument("ros2msg: " + text);
}

bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}
bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// a-z, 0-9 and single '_' inside, a letter first.
bool is_snake_case(std::string_view name) {
  if (name.empty() || name.size() > max_name || !is_lower(name.front()) || name.back() == '_')
    return false;
  if (name.find("__") != std::string_view::npos) return false;
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return is_lower(c) || is_digit(c) || c == '_'; });
}

bool is_camel_case(std::string_view name) {
  if (name.empty() || name.size() > max_name || !is_upper(name.front())) return false;
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return is_lower(c) || is_upper(c) || is_digit(c); });
}

bool is_message_name(std::string_view name) {
  const std::size_t slash = name.find('/');
  return slash != std::string_view::npos && is_snake_case(name.substr(0, slash)) &&
         is_camel_case(name.substr(slash + 1));
}

void check_comment(const std::string& comment, const std::string& owner) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
  if (std::any_of(comment.begin(), comment.end(), is_control))
    refuse_schema("the comment of '" + owner + "' must be one line without control characters");
}

void check_field(const Ros2Field& field, const Ros2Message& message) {
  const std::string owner = message.name + "." + field.name;
  if (!is_snake_case(field.name))
    refuse_schema(
        "field name '" + field.name + "' of " + message.name +
        " must be of a-z, 0-9 and single '_', begin with a letter and not end with '_', e.g. "
        "'position_x'");
  if (find_ros2_type(field.type) == nullptr && !is_message_name(field.type))
    refuse_schema("type '" + field.type + "' of '" + owner +
                  "' must be a primitive, e.g. 'float64', or a message, e.g. 'trocar/Vector3'");
  check_comment(field.comment, owner);
}

void check_message(const Ros2Message& message) {
  if (!is_message_name(message.name))
    refuse_schema(
        "message name '" + message.name +
        "' must be a package in snake_case, '/' and a name in CamelCase, e.g. 'trocar/Row'");
  if (message.fields.empty()) refuse_schema(message.name + " must have at least one field");
  check_comment(message.comment, message.name);
  std::set<std::string_view> names;
  for (const Ros2Field& field : message.fields) {
    check_field(field, message);
    if (!names.insert(field.name).second)
      refuse_schema("field '" + field.name + "' stands twice in " + message.name);
  }
}

using Definitions = std::map<std::string_view, const Ros2Message*>;

/// Depth of nesting below `message`; each definition is measured once.
int depth_of(const Ros2Message& message, const Definitions& definitions,
             std::map<std::string_view, int>& known, int above) {
  constexpr int being_measured = -1;
  if (above > max_depth)
    refuse_schema("messages are nested more than " + std::to_string(max_depth) + " deep at " +
                  message.name);
  const auto [entry, is_new] = known.emplace(message.name, being_measured);
  if (!is_new && entry->second == being_measured) refuse_schema(message.name + " contains itself");
  if (!is_new) return entry->second;
  int depth = 0;
  for (const Ros2Field& field : message.fields) {
    if (find_ros2_type(field.type) != nullptr) continue;
    const auto nested = definitions.find(field.type);
    if (nested == definitions.end())
      refuse_schema("type '" + field.type + "' of '" + message.name + "." + field.name +
                    "' is not defined; add its definition");
    depth = std::max(depth, 1 + depth_of(*nested->second, definitions, known, above + 1));
  }
  if (above + depth > max_depth)
    refuse_schema("messages are nested more than " + std::to_string(max_depth) + " deep at " +
                  message.name);
  return known[message.name] = depth;
}

std::string line_of(const Ros2Field& field) {
  std::string line = field.type;
  if (field.array_length > 0) line += '[' + std::to_string(field.array_length) + ']';
  line += ' ' + field.name;
  if (!field.comment.empty()) line += "  # " + field.comment;
  return line + '\n';
}

}  // namespace

const Ros2TypeName* find_ros2_type(std::string_view name) {
  const auto* found = std::find_if(ros2_types.begin(), ros2_types.end(),
                                   [&](const Ros2TypeName& type) { return type.name == name; });
  return found == ros2_types.end() ? nullptr : found;
}

std::string ros2_short_name(std::string_view name) {
  std::string text(name);
  const std::size_t middle = text.find("/msg/");
  if (middle != std::string::npos) text.erase(middle, 4);
  return text;
}

void check_ros2_messages(const std::vector<Ros2Message>& messages) {
  if (messages.empty()) refuse_schema("a schema needs a message");
  Definitions definitions;
  for (const Ros2Message& message : messages) {
    check_message(message);
    if (!definitions.emplace(message.name, &message).second)
      refuse_schema(message.name + " is defined twice");
  }
  std::map<std::string_view, int> known;
  for (const Ros2Message& message : messages) depth_of(message, definitions, known, 0);
}

std::string ros2_schema_text(const std::vector<Ros2Message>& messages) {
  check_ros2_messages(messages);
  std::string text;
  for (const Ros2Message& message : messages) {
    if (&message != &messages.front())
      text += std::string(80, '=') + "\nMSG: " + message.name + '\n';
    if (!message.comment.empty()) text += "# " + message.comment + '\n';
    for (const Ros2Field& field : message.fields) text += line_of(field);
  }
  return text;
}

}  // namespace trocar
