// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/log_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "framework/recording/cdr.hpp"
#include "framework/recording/event_message.hpp"

namespace trocar {
namespace {

constexpr std::byte cdr_little_endian[cdr_head] = {std::byte{0}, std::byte{1}, std::byte{0},
                                                   std::byte{0}};

std::string published_schema() {
  return ros2_schema_text(
      {{"trocar/Published", {{"name", "string", 0, {}}, {"json", "string", 0, "one row"}}, {}}});
}

}  // namespace

LogFile::LogFile(const std::string& path, std::uint64_t epoch_ns)
    : path_(path), writer_(path), start_ns_(epoch_ns) {}

void LogFile::attach(std::string_view name, std::string_view media_type, std::string_view content) {
  writer_.attachment(name, media_type, start_ns_, 0,
                     std::as_bytes(std::span(content.data(), content.size())));
}

void LogFile::publish(std::string_view name, std::string_view json) {
  if (!has_published_channel_) {
    const std::uint16_t schema = writer_.schema("trocar/Published", "ros2msg", published_schema());
    published_channel_ = writer_.channel("/published", schema, "cdr");
    has_published_channel_ = true;
  }
  std::vector<std::byte> message;
  CdrWriter cdr(message);
  cdr.string(name);
  cdr.string(json);
  writer_.message(published_channel_, published_++, start_ns_, start_ns_, message);
}

void LogFile::close() {
  writer_.close();
}

std::string LogFile::topic(std::string_view name) const {
  return run_ <= 1 ? fmt::format("/{}", name) : fmt::format("/run{}/{}", run_, name);
}

Recorder::Recorder(LogFile& log, RowLayout::Selection wanted)
    : log_(log), wanted_(std::move(wanted)) {}

void Recorder::begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) {
  start_ns_ = last_ns_ = log_.begin_run();
  const std::vector<RowLayout> narrow = layouts_of(graph, wanted_);
  for (std::size_t i = 0; i < layouts.size(); ++i)
    groups_.push_back(begin_group(layouts[i], narrow[i]));
  McapWriter& writer = log_.writer();
  const std::uint16_t event = writer.schema("trocar/Event", "ros2msg", event_schema());
  events_ = writer.channel(log_.topic("events"), event, "cdr");
}

Recorder::Group Recorder::begin_group(const RowLayout& layout, const RowLayout& narrow) {
  Group group;
  group.name = layout.name();
  const std::size_t head =
      layout.ports().empty() ? layout.size() : layout.ports().front().row_offset;
  group.pieces = {{0, 0, head}};
  std::map<std::string_view, std::size_t> full;
  for (const RowPort& port : layout.ports()) full.emplace(port.name, port.row_offset);
  for (const RowPort& port : narrow.ports())
    group.pieces.push_back({full.at(port.name), port.row_offset, port.size});
  group.message.assign(cdr_head + narrow.size(), std::byte{0});
  std::memcpy(group.message.data(), cdr_little_endian, cdr_head);

  McapWriter& writer = log_.writer();
  const std::uint16_t schema =
      writer.schema("trocar/Row", "ros2msg", ros2_schema_text(narrow.messages()));
  group.channel = writer.channel(log_.topic(layout.name()), schema, "cdr",
                                 {{"period_ns", std::to_string(layout.period_ns())}});
  return group;
}

void Recorder::row(std::size_t index, std::span<const std::byte> row) {
  Group& group = groups_[index];
  const RowHeader header = header_of(row);
  write_missed(index, header.tick, header.time);
  for (const Piece& piece : group.pieces)
    std::memcpy(group.message.data() + cdr_head + piece.to, row.data() + piece.from, piece.size);
  const std::uint64_t time = start_ns_ + static_cast<std::uint64_t>(header.time);
  last_ns_ = std::max(last_ns_, time);
  log_.writer().message(group.channel, static_cast<std::uint32_t>(header.tick), time, time,
                        group.message);
}

void Recorder::event(std::size_t group, const Event& event) {
  write_missed(group, event.tick, event.time_ns);
  write(group, event);
}

void Recorder::write_missed(std::size_t group, std::int64_t tick, std::int64_t time_ns) {
  if (missed_ > 0) write(group, missed_event(name, missed_, tick, time_ns));
  missed_ = 0;
}

void Recorder::write(std::size_t group, const Event& event) {
  std::vector<std::byte> message;
  write_event(event, groups_[group].name, message);
  const std::uint64_t time = start_ns_ + static_cast<std::uint64_t>(event.time_ns);
  log_.writer().message(events_, event_count_++, time, time, message);
}

void Recorder::end() {
  log_.end_run(last_ns_);
  log_.writer().flush();
}

}  // namespace trocar
