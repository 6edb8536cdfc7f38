// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/played_reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "framework/text.hpp"
#include "framework/units.hpp"

namespace trocar::hid {
namespace {

constexpr double longest_play = 1e6;  // [s]

[[noreturn]] void refuse_entry(const std::string& what, const Literal& value,
                               const std::string& needed) {
  throw std::invalid_argument(fmt::format("{} = {}: needs {}", what, value.text(), needed));
}

std::int64_t moment(const Literal& value) {
  const auto* text = value.as<std::string>();
  const auto* number = value.as<double>();
  if (number != nullptr && *number == 0.0) return 0;
  try {
    const Quantity at = text != nullptr ? parse_quantity(*text) : Quantity{-1.0, {}};
    if (at.unit.dimension == parse_unit("s").dimension && at.value >= 0.0 &&
        at.value <= longest_play)
      return std::llround(at.value * 1e9);
  } catch (const UnitError&) {
  }
  refuse_entry("at", value, "s, from 0 to 1e6, e.g. \"20 ms\"");
}

std::vector<std::uint8_t> bytes_of_text(const Literal& value, const std::string& text) {
  std::vector<std::uint8_t> bytes;
  for (const std::string_view word : split(text, ' ')) {
    for (std::size_t i = 0; i < word.size(); i += 2) {
      std::uint8_t byte = 0;
      const char* const begin = word.data() + i;
      const char* const end = begin + std::min<std::size_t>(2, word.size() - i);
      if (end - begin != 2 || std::from_chars(begin, end, byte, 16).ptr != end)
        refuse_entry("bytes", value, "two hexadecimal digits for each byte, e.g. \"01 5e 01\"");
      bytes.push_back(byte);
    }
  }
  return bytes;
}

std::vector<std::uint8_t> bytes_of_list(const Literal& value, const Literal::List& list) {
  std::vector<std::uint8_t> bytes;
  for (const Literal& each : list) {
    const auto* byte = each.as<double>();
    if (byte == nullptr || !(*byte >= 0.0 && *byte <= 255.0) || *byte != std::floor(*byte))
      refuse_entry("bytes", value, "whole numbers from 0 to 255");
    bytes.push_back(static_cast<std::uint8_t>(*byte));
  }
  return bytes;
}

std::vector<std::uint8_t> bytes_of(const Literal& value) {
  std::vector<std::uint8_t> bytes;
  if (const auto* text = value.as<std::string>())
    bytes = bytes_of_text(value, *text);
  else if (const auto* list = value.as<Literal::List>())
    bytes = bytes_of_list(value, *list);
  if (bytes.empty() || bytes.size() > largest_report)
    refuse_entry("bytes", value,
                 fmt::format("1 to {} bytes, as \"01 5e 01\" or {{ 1, 94, 1 }}", largest_report));
  return bytes;
}

}  // namespace

PlayedReports::PlayedReports(const Literal& list) {
  const auto* entries = list.as<Literal::List>();
  if (entries == nullptr || entries->empty())
    refuse_entry("play", list, "a list, e.g. { { at = \"0 s\", bytes = \"01 5e 01\" } }");
  for (std::size_t i = 0; i < entries->size(); ++i) {
    try {
      entries_.push_back(entry((*entries)[i]));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("play, entry {}: {}", i + 1, error.what()));
    }
  }
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.at_ns < b.at_ns; });
}

PlayedReports::Entry PlayedReports::entry(const Literal& value) {
  static const std::vector<std::string> known = {"at", "bytes", "plug"};
  const auto* table = value.as<Literal::Table>();
  if (table == nullptr)
    throw std::invalid_argument(fmt::format(
        "{}: needs a table, e.g. {{ at = \"0 s\", bytes = \"01 5e 01\" }}", value.text()));
  Entry entry;
  bool timed = false;
  int contents = 0;
  for (const Literal::Entry& each : *table) {
    if (each.key == "at") {
      entry.at_ns = moment(each.value);
      timed = true;
    } else if (each.key == "bytes") {
      entry.bytes = bytes_of(each.value);
      ++contents;
    } else if (each.key == "plug") {
      const auto* way = each.value.as<std::string>();
      if (way == nullptr || (*way != "out" && *way != "in"))
        refuse_entry("plug", each.value, "\"out\" or \"in\"");
      entry.kind = *way == "out" ? Kind::plug_out : Kind::plug_in;
      ++contents;
    } else {
      throw std::invalid_argument(
          fmt::format("there is no \"{}\"{}", each.key, suggestion(each.key, known)));
    }
  }
  if (!timed) throw std::invalid_argument("needs its time, at = \"20 ms\"");
  if (contents != 1) throw std::invalid_argument("needs bytes or plug, one of them");
  return entry;
}

void PlayedReports::begin(InputSnapshot& snapshot) RT_SAFE {
  next_ = 0;
  snapshot.attach();
}

void PlayedReports::play(std::int64_t time_ns, const InputLayout& layout,
                         InputSnapshot& snapshot) RT_SAFE {
  for (; next_ < entries_.size() && entries_[next_].at_ns <= time_ns; ++next_) {
    const Entry& entry = entries_[next_];
    if (entry.kind == Kind::plug_out)
      snapshot.detach();
    else if (entry.kind == Kind::report && snapshot.attached)
      snapshot.take(layout, entry.bytes, entry.at_ns);
    else if (entry.kind == Kind::plug_in && !snapshot.attached)
      snapshot.attach();
  }
}

}  // namespace trocar::hid
