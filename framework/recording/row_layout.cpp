// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/row_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <map>
#include <set>

#include "framework/text.hpp"

namespace trocar {
namespace {

std::size_t recorded_size(const Signature& signature) {
  const std::size_t fields = field_count(*signature.type, signature.axes);
  if (signature.type->per_axis > 0) return 8 * fields;
  return signature.type->size;
}

std::size_t align(std::size_t offset, std::size_t size) {
  const std::size_t alignment = size == 1 ? 1 : 8;
  return (offset + alignment - 1) / alignment * alignment;
}

std::string camel_case(std::string_view name) {
  std::string result;
  bool up = true;
  for (const char c : name) {
    if (c == '_' || c == '.') {
      up = true;
      continue;
    }
    result += up ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    up = false;
  }
  return result;
}

/// `wanted`, or with the first number behind it that makes it free.
template <typename IsTaken>
std::string free_name(const std::string& wanted, const char* joint, const IsTaken& is_taken) {
  std::string name = wanted;
  for (int i = 2; is_taken(name); ++i) name = wanted + joint + std::to_string(i);
  return name;
}

/// As ROS 2 takes it: small letters, digits and single underscores inside.
std::string field_name(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const bool separates = c == '_' || c == '.';
    if (separates && (result.empty() || result.back() == '_')) continue;
    result += separates ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  while (result.ends_with('_')) result.pop_back();
  return result;
}

/// A message in the making: no two of its fields have one name.
class MessageDraft {
 public:
  explicit MessageDraft(const std::string& name, std::vector<Ros2Field> head = {})
      : message_{name, std::move(head), {}} {
    for (const Ros2Field& field : message_.fields) names_.insert(field.name);
  }
  void add_field(std::string_view name, std::string type, std::string comment) {
    std::string own =
        free_name(field_name(name), "_", [&](const std::string& n) { return names_.contains(n); });
    names_.insert(own);
    message_.fields.push_back({std::move(own), std::move(type), 0, std::move(comment)});
  }
  Ros2Message take() { return std::move(message_); }

 private:
  Ros2Message message_;
  std::set<std::string> names_;
};

/// Gathers the messages of a row: one for each component and group, and the types that they use.
class SchemaBuilder {
 public:
  SchemaBuilder(std::vector<Ros2Field> head, const std::vector<RowPort>& ports) {
    begin_message("trocar/Row", std::move(head));
    for (const RowPort& port : ports) add(port);
  }
  std::vector<Ros2Message> take() {
    std::vector<Ros2Message> messages;
    for (MessageDraft& draft : messages_) messages.push_back(draft.take());
    return messages;
  }

 private:
  void add(const RowPort& port) {
    std::string path;
    std::size_t parent = 0;
    const std::vector<std::string_view> parts = split(port.name, '.');
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
      path += (path.empty() ? "" : ".") + std::string(parts[i]);
      parent = node(parent, std::string(parts[i]), path);
    }
    std::string comment = unit_list(port.signature);
    if (!port.signature.frame.empty()) comment += " in " + port.signature.frame;
    for (std::size_t i = 0; i < port.labels.size(); ++i)
      comment += fmt::format("{}{} {}", i == 0 ? "" : ", ", i, port.labels[i]);
    const std::string type = type_name(port.signature);
    messages_[parent].add_field(parts.back(), type,
                                comment + (comment.empty() ? "" : " ") + port.doc);
  }

  static std::string unit_list(const Signature& signature) {
    std::vector<std::string> symbols;
    for (const Unit& unit : signature.units) symbols.push_back(si_symbol(unit.dimension));
    const std::string all = join(symbols, ", ");
    return all.empty() ? "" : "[" + all + "]";
  }

  std::size_t node(std::size_t parent, const std::string& name, const std::string& path) {
    const auto [found, is_new] = nodes_.emplace(path, messages_.size());
    if (is_new) {
      // "a.b" and "a_b" read alike in CamelCase.
      const std::string message =
          free_name("trocar/Node" + camel_case(path), "N",
                    [&](const std::string& other) { return names_.contains(other); });
      messages_[parent].add_field(name, message, {});
      begin_message(message);
    }
    return found->second;
  }

  std::string type_name(const Signature& signature) {
    const TypeInfo& type = *signature.type;
    if (type.fields.empty())
      return type.scalar == Scalar::real      ? "float64"
             : type.scalar == Scalar::integer ? "int64"
                                              : "bool";
    const std::string name = "trocar/" + type.name +
                             (type.per_axis > 0 ? std::to_string(signature.axes) : std::string());
    if (types_.emplace(name, true).second) {
      std::vector<Ros2Field> fields;
      for (std::size_t i = 0; i < field_count(type, signature.axes); ++i)
        fields.push_back({type.fields[i].name, type_name({type.fields[i].type, 0, {}, {}}), 0, {}});
      begin_message(name, std::move(fields));
    }
    return name;
  }

  void begin_message(const std::string& name, std::vector<Ros2Field> fields = {}) {
    messages_.emplace_back(name, std::move(fields));
    names_.insert(name);
  }

  std::vector<MessageDraft> messages_;
  std::set<std::string> names_;  // of messages
  std::map<std::string, std::size_t> nodes_;
  std::map<std::string, bool> types_;
};

void add_signals(const std::string& name, const Signature& signature, std::size_t offset,
                 std::vector<RowSignal>& signals) {
  const TypeInfo& type = *signature.type;
  if (type.fields.empty()) {
    signals.push_back({name, type.scalar, signature.units.front(), offset, 0});
    return;
  }
  for (std::size_t i = 0; i < field_count(type, signature.axes); ++i) {
    const FieldSelection field = select_field(signature, type.fields[i].name);
    add_signals(name + "." + type.fields[i].name, field.signature, offset + field.offset, signals);
  }
}

/// A nested message's fields lie together: a group's ports must, though the schedule may put other
/// components between them. Each name stands where its first port came.
void keep_groups_together(std::vector<RowPort>& ports) {
  std::map<std::string, std::size_t> first;  // of each prefix of a name
  std::vector<std::pair<std::vector<std::size_t>, RowPort>> keyed;
  for (RowPort& port : ports) {
    std::vector<std::size_t> key;
    for (std::size_t dot = port.name.find('.');; dot = port.name.find('.', dot + 1)) {
      key.push_back(first.emplace(port.name.substr(0, dot), first.size()).first->second);
      if (dot == std::string::npos) break;
    }
    keyed.emplace_back(std::move(key), std::move(port));
  }
  std::sort(keyed.begin(), keyed.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < ports.size(); ++i) ports[i] = std::move(keyed[i].second);
}

}  // namespace

RowLayout::RowLayout(const RateGroup& group, const Selection& wanted)
    : name_(group.name()), period_ns_(group.period_ns()) {
  for (const ScheduleItem& item : group.schedule()) components_.push_back(item.component->name());
  add_ports(group, wanted);
  keep_groups_together(ports_);
  size_ = sizeof(RowHeader) + 8 * components_.size();
  for (RowPort& port : ports_) {
    port.row_offset = align(size_, port.size);
    has_gaps_ = has_gaps_ || port.row_offset != size_;
    size_ = port.row_offset + port.size;
    add_segment(port);
  }
}

/// What a device reports, and what is read from other threads, is recorded whatever is wanted:
/// nothing else is needed to compute the rest again.
void RowLayout::add_ports(const RateGroup& group, const Selection& wanted) {
  for (const ScheduleItem& item : group.schedule()) {
    const bool device = dynamic_cast<const Device*>(item.component) != nullptr;
    for (const OutputPort* output : item.component->outputs()) {
      RowPort port{item.component->name() + "." + output->name(),
                   *output->signature(),
                   output->doc(),
                   output->labels(),
                   group.offset_of(*output),
                   0,
                   recorded_size(*output->signature())};
      if (wanted && !device && !wanted(port.name)) continue;
      ports_.push_back(std::move(port));
    }
  }
  for (const Arrival& arrival : group.arrivals()) {
    const std::string name = arrival.input->owner_name() + "." + arrival.input->name();
    ports_.push_back({name, arrival.signature, "as read: " + arrival.crossing->text(),
                      arrival.input->labels(), group.offset_of(arrival.value), 0,
                      recorded_size(arrival.signature)});
    const auto add = [&](const char* suffix, const TypeInfo& type, const void* value,
                         const char* doc) {
      const Signature signature{&type, 0, {parse_unit("")}, ""};
      ports_.push_back(
          {name + suffix, signature, doc, {}, group.offset_of(value), 0, recorded_size(signature)});
    };
    add("_tick", type_info<std::int64_t>(), arrival.tick, "of the thread that it comes from");
    add("_valid", type_info<bool>(), arrival.valid, "it arrived, is not stale, and is sound");
  }
}

std::vector<RowLayout> layouts_of(const WiredGraph& graph, const RowLayout::Selection& wanted) {
  std::vector<RowLayout> layouts;
  for (const RateGroup& group : graph.groups()) layouts.emplace_back(group, wanted);
  return layouts;
}

void RowLayout::add_segment(const RowPort& port) {
  if (!segments_.empty()) {
    Segment& last = segments_.back();
    if (last.memory_offset + last.size == port.memory_offset &&
        last.row_offset + last.size == port.row_offset) {
      last.size += port.size;
      return;
    }
  }
  segments_.push_back({port.memory_offset, port.row_offset, port.size});
}

void RowLayout::capture(const RowHeader& header, std::span<const std::int64_t> times,
                        const std::byte* memory, std::span<std::byte> row) const RT_SAFE {
  if (has_gaps_) std::memset(row.data(), 0, row.size());  // or old bytes would get into the log
  std::memcpy(row.data(), &header, sizeof header);
  if (!times.empty()) std::memcpy(row.data() + sizeof header, times.data(), times.size_bytes());
  for (const Segment& segment : segments_)
    std::memcpy(row.data() + segment.row_offset, memory + segment.memory_offset, segment.size);
}

std::vector<RowSignal> RowLayout::signals() const {
  std::vector<RowSignal> signals;
  for (const RowPort& port : ports_)
    add_signals(port.name, port.signature, port.row_offset, signals);
  return signals;
}

std::vector<Ros2Message> RowLayout::messages() const {
  std::vector<Ros2Field> head = {
      {"tick", "int64", 0, "number of the slot"},
      {"time", "int64", 0, "[ns] of the slot since the start"},
      {"lateness", "int64", 0, "[ns] of the tick's beginning; 0 in virtual time"},
      {"duration", "int64", 0, "[ns] of the tick before; 0 in virtual time"},
      {"flags", "int64", 0, "1 fault latched, 2 rendering, 4 slots skipped before this one"}};
  MessageDraft draft("trocar/StepTimes");
  for (const std::string& component : components_) draft.add_field(component, "int64", {});
  Ros2Message times = draft.take();
  if (!components_.empty())  // a message needs a field
    head.push_back(
        {"step_times", times.name, 0, "[ns] of each component in this tick; 0 in virtual time"});
  std::vector<Ros2Message> messages = SchemaBuilder(std::move(head), ports_).take();
  if (!components_.empty()) messages.push_back(std::move(times));
  return messages;
}

}  // namespace trocar
