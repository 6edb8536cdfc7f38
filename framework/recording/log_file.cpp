// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/log_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "framework/recording/cdr.hpp"

namespace trocar {
namespace {

constexpr std::byte cdr_little_endian[cdr_head] = {std::byte{0}, std::byte{1}, std::byte{0},
                                                   std::byte{0}};

std::string event_schema() {
  return ros2_schema_text({{"trocar/Event",
                            {{"tick", "int64", 0, {}},
                             {"time", "int64", 0, "[ns] since the start"},
                             {"kind", "string", 0, {}},
                             {"source", "string", 0, "component"},
                             {"detail", "string", 0, {}},
                             {"value", "float64", 0, "that caused it"},
                             {"limit", "float64", 0, "that it broke"}},
                            {}}});
}

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

void Recorder::begin(const RowLayout& layout, const WiredGraph& graph) {
  start_ns_ = last_ns_ = log_.begin_run();
  const RowLayout narrow(graph, wanted_);
  const std::size_t head =
      layout.ports().empty() ? layout.size() : layout.ports().front().row_offset;
  pieces_ = {{0, 0, head}};
  for (const RowPort& port : narrow.ports()) {
    const auto full = std::find_if(layout.ports().begin(), layout.ports().end(),
                                   [&](const RowPort& other) { return other.name == port.name; });
    pieces_.push_back({full->row_offset, port.row_offset, port.size});
  }
  message_.assign(cdr_head + narrow.size(), std::byte{0});
  std::memcpy(message_.data(), cdr_little_endian, cdr_head);

  McapWriter& writer = log_.writer();
  const std::uint16_t row_schema =
      writer.schema("trocar/Row", "ros2msg", ros2_schema_text(narrow.messages()));
  rows_ = writer.channel(log_.topic("main"), row_schema, "cdr",
                         {{"period_ns", std::to_string(graph.period_ns())}});
  const std::uint16_t event = writer.schema("trocar/Event", "ros2msg", event_schema());
  events_ = writer.channel(log_.topic("events"), event, "cdr");
}

void Recorder::row(std::span<const std::byte> row) {
  const RowHeader header = header_of(row);
  write_missed(header.tick, header.time);
  for (const Piece& piece : pieces_)
    std::memcpy(message_.data() + cdr_head + piece.to, row.data() + piece.from, piece.size);
  last_ns_ = start_ns_ + static_cast<std::uint64_t>(header.time);
  log_.writer().message(rows_, static_cast<std::uint32_t>(header.tick), last_ns_, last_ns_,
                        message_);
}

void Recorder::event(const Event& event) {
  write_missed(event.tick, event.time_ns);
  write(event);
}

void Recorder::write_missed(std::int64_t tick, std::int64_t time_ns) {
  if (missed_ > 0) write(missed_event(name, missed_, tick, time_ns));
  missed_ = 0;
}

void Recorder::write(const Event& event) {
  std::vector<std::byte> message;
  CdrWriter cdr(message);
  cdr.number(event.tick);
  cdr.number(event.time_ns);
  cdr.string(to_string(event.kind));
  cdr.string(event.source);
  const std::string_view what = event.what;
  const std::string_view detail = event.detail;
  cdr.string(fmt::format("{}{}{}", what, what.empty() || detail.empty() ? "" : ": ", detail));
  cdr.number(event.value);
  cdr.number(event.limit);
  const std::uint64_t time = start_ns_ + static_cast<std::uint64_t>(event.time_ns);
  log_.writer().message(events_, event_count_++, time, time, message);
}

void Recorder::end() {
  log_.end_run(last_ns_);
  log_.writer().flush();
}

}  // namespace trocar
