// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/schema_signals.hpp"

#include <fnmatch.h>

#include <algorithm>

#include "framework/text.hpp"
#include "framework/types.hpp"

namespace trocar {
namespace {

using Units = std::vector<std::string>;

/// "[N, N m] force and moment" gives N and N m.
Units units_in(const std::string& comment) {
  const std::size_t end = comment.find(']');
  if (!comment.starts_with('[') || end == std::string::npos) return {};
  Units units;
  for (const std::string_view unit : split(std::string_view(comment).substr(1, end - 1), ','))
    units.emplace_back(trim(unit));
  return units;
}

/// The port type that a message stands for: "trocar/Joints6" is Joints. Null when it is none.
const TypeInfo* port_type(const std::string& message) {
  std::string name = message.substr(message.rfind('/') + 1);
  const auto find = [&name]() -> const TypeInfo* {
    for (const TypeInfo* type : port_types())
      if (type->name == name) return type;
    return nullptr;
  };
  if (const TypeInfo* type = find()) return type;
  name.erase(name.find_last_not_of("0123456789") + 1);
  return find();
}

class SchemaWalk {
 public:
  explicit SchemaWalk(const std::vector<Ros2Message>& messages) : messages_(messages) {}

  std::vector<SchemaSignal> signals() {
    walk(messages_.front(), "", {}, "");
    return std::move(signals_);
  }

 private:
  void walk(const Ros2Message& message, const std::string& prefix, const Units& outer,
            const std::string& port) {
    for (std::size_t i = 0; i < message.fields.size(); ++i) {
      const Ros2Field& field = message.fields[i];
      Units units = units_in(field.comment);
      if (units.empty()) units = inherited(message, i, outer);
      const std::string path = prefix + field.name;
      if (field.array_length == 0) add(field, path, units, port.empty() ? path : port);
      for (std::uint32_t k = 0; k < field.array_length; ++k)
        add(field, path + '[' + std::to_string(k) + ']', units, port.empty() ? path : port);
    }
  }

  static Units inherited(const Ros2Message& message, std::size_t field, const Units& outer) {
    if (outer.size() <= 1) return outer;
    const TypeInfo* type = port_type(message.name);
    const std::size_t block =
        type != nullptr && field < type->fields.size() ? type->fields[field].block : field;
    return block < outer.size() ? Units{outer[block]} : Units{};
  }

  void add(const Ros2Field& field, const std::string& path, const Units& units,
           const std::string& port) {
    if (const Ros2TypeName* type = find_ros2_type(field.type)) {
      signals_.push_back({.name = path,
                          .unit = join(units, ", "),
                          .port = port,
                          .is_text = type->type == Ros2Type::string});
      return;
    }
    const auto nested = std::find_if(messages_.begin(), messages_.end(), [&](const auto& message) {
      return message.name == field.type;
    });
    if (nested == messages_.end()) return;
    walk(*nested, path + '.', units, port_type(field.type) != nullptr ? port : "");
  }

  const std::vector<Ros2Message>& messages_;
  std::vector<SchemaSignal> signals_;
};

}  // namespace

std::vector<SchemaSignal> signals_of(const std::vector<Ros2Message>& messages) {
  return SchemaWalk(messages).signals();
}

bool matches(std::string_view pattern, const std::string& name) {
  if (pattern.find_first_of("*?") == std::string_view::npos)
    return name.find(pattern) != std::string::npos;
  return ::fnmatch(std::string(pattern).c_str(), name.c_str(), FNM_NOESCAPE) == 0;
}

}  // namespace trocar
