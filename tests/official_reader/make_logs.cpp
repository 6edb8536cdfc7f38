// SPDX-License-Identifier: Apache-2.0
// Writes the logs that the official readers judge: make_logs DIR.

#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "framework/recording/cdr.hpp"
#include "framework/recording/mcap_writer.hpp"
#include "framework/recording/ros2_schema.hpp"

namespace {

using trocar::CdrWriter;
using trocar::McapWriter;
using trocar::Ros2Field;
using trocar::Ros2Message;

constexpr std::uint64_t ms = 1'000'000;  // [ns]
constexpr int rows = 3000;
constexpr std::uint32_t samples = 140;  // makes a row of 1.2 kB

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::string row_schema() {
  return trocar::ros2_schema_text({
      {"trocar/Row",
       {{"valid", "bool"},
        {"tick", "int64", 0, "number of the tick"},
        {"wall", "trocar/Wall", 0, "the soft one"},
        {"sides", "trocar/Wall", 2, "left and right"},
        {"a_i8", "int8"},
        {"a_u8", "uint8"},
        {"a_i16", "int16"},
        {"a_u16", "uint16"},
        {"a_i32", "int32"},
        {"a_u32", "uint32"},
        {"a_u64", "uint64"},
        {"a_f32", "float32"},
        {"flags", "bool", 3},
        {"samples", "float64", samples, "[N]"}},
       "One row a tick: every type that a schema knows."},
      {"trocar/Wall",
       {{"touched", "bool"}, {"force", "trocar/Vector3", 0, "[N], world frame"}},
       ""},
      {"trocar/Vector3", {{"x", "float64"}, {"y", "float64"}, {"z", "float64"}}, ""},
  });
}

void write_wall(CdrWriter& cdr, int tick) {
  cdr.boolean(tick % 2 == 0);
  for (int axis = 0; axis < 3; ++axis) cdr.number(0.001 * tick + axis);
}

void write_row(CdrWriter& cdr, int tick) {
  cdr.boolean(true);
  cdr.number(std::int64_t{tick});
  for (int wall = 0; wall < 3; ++wall) write_wall(cdr, tick + wall);
  cdr.number(std::numeric_limits<std::int8_t>::min());
  cdr.number(std::numeric_limits<std::uint8_t>::max());
  cdr.number(std::numeric_limits<std::int16_t>::min());
  cdr.number(std::numeric_limits<std::uint16_t>::max());
  cdr.number(std::numeric_limits<std::int32_t>::min());
  cdr.number(std::numeric_limits<std::uint32_t>::max());
  cdr.number(std::numeric_limits<std::uint64_t>::max());
  cdr.number(0.5f);
  for (int i = 0; i < 3; ++i) cdr.boolean(i == 1);
  for (std::uint32_t i = 0; i < samples; ++i) cdr.number(tick + 0.01 * i);
}

void write_good(const std::string& path, const std::string& schema_text) {
  McapWriter log(path);
  const auto row_type = log.schema("trocar/msg/Row", "ros2msg", schema_text);
  const auto event_type = log.schema(
      "trocar/msg/Event", "ros2msg",
      trocar::ros2_schema_text({{"trocar/Event",
                                 {{"tick", "int64"}, {"kind", "string"}, {"text", "string"}},
                                 "What happened at a tick."}}));
  const auto row_channel = log.channel("/rows", row_type, "cdr", {{"rate", "1 kHz"}});
  const auto event_channel = log.channel("/events", event_type, "cdr");
  log.attachment("wall.lua", "text/x-lua", 0, 0, bytes_of("trocar.Wall {}\n"));
  log.attachment("empty.txt", "text/plain", 0, 0, {});
  log.metadata("run", {{"seed", "7"}, {"clock", "simulated"}});
  std::vector<std::byte> message;
  for (int tick = 0; tick < rows; ++tick) {
    const auto sequence = static_cast<std::uint32_t>(tick);
    const std::uint64_t time = sequence * ms;
    CdrWriter row(message);
    write_row(row, tick);
    log.message(row_channel, sequence, time, time, message);
    if (tick % 1000 != 0) continue;
    CdrWriter event(message);
    event.number(std::int64_t{tick});
    event.string(tick == 0 ? "" : "fault");
    event.string("wall.force: 3 N above the limit – größer als erlaubt");
    log.message(event_channel, sequence, time, time, message);
  }
  log.close();
}

void save(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_logs DIR\n", stderr);
    return 2;
  }
  const std::string folder = std::string(argv[1]) + '/';
  write_good(folder + "good.mcap", row_schema());
  write_good(folder + "wrong_schema.mcap", row_schema() + "float64 more\n");
  McapWriter(folder + "empty.mcap").close();

  std::ifstream good(folder + "good.mcap", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(good), {}};
  save(folder + "cut.mcap", bytes.substr(0, bytes.size() / 2));
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  save(folder + "flipped.mcap", bytes);
}
