// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "framework/realtime/rt_safe.hpp"

/// @file
/// Little-endian fields of a report, written and read in the order in which they stand. Layouts
/// are constants, so cursors do not check for the end: tests and the sanitizers do.

namespace trocar::hid {

constexpr std::size_t report_size = 64;
constexpr std::size_t axes = 6;

using Report = std::array<std::uint8_t, report_size>;
using ReportBytes = std::span<const std::uint8_t>;  // as received, of any length

template <typename T>
using PerAxis = std::array<T, axes>;

class ReportWriter {
 public:
  explicit ReportWriter(Report& report) RT_SAFE : report_(report) {}
  void skip_to(std::size_t offset) RT_SAFE { at_ = offset; }
  void u8(std::uint8_t value) RT_SAFE { put(value, 1); }
  void u16(std::uint16_t value) RT_SAFE { put(value, 2); }
  void i16(std::int16_t value) RT_SAFE { put(static_cast<std::uint16_t>(value), 2); }
  void i24(std::int32_t value) RT_SAFE { put(static_cast<std::uint32_t>(value), 3); }
  void u32(std::uint32_t value) RT_SAFE { put(value, 4); }
  void i32(std::int32_t value) RT_SAFE { put(static_cast<std::uint32_t>(value), 4); }
  void f32(float value) RT_SAFE { put(std::bit_cast<std::uint32_t>(value), 4); }

 private:
  void put(std::uint32_t value, int size) RT_SAFE {
    for (int i = 0; i < size; ++i) report_[at_++] = static_cast<std::uint8_t>(value >> (8 * i));
  }
  Report& report_;
  std::size_t at_ = 0;
};

class ReportReader {
 public:
  /// @param bytes at least report_size of them
  explicit ReportReader(ReportBytes bytes) RT_SAFE : bytes_(bytes) {}
  void skip_to(std::size_t offset) RT_SAFE { at_ = offset; }
  std::uint8_t u8() RT_SAFE { return static_cast<std::uint8_t>(get(1)); }
  std::uint16_t u16() RT_SAFE { return static_cast<std::uint16_t>(get(2)); }
  std::int16_t i16() RT_SAFE { return static_cast<std::int16_t>(get(2)); }
  std::int32_t i24() RT_SAFE { return static_cast<std::int32_t>(get(3) << 8) >> 8; }
  std::uint32_t u32() RT_SAFE { return get(4); }
  std::int32_t i32() RT_SAFE { return static_cast<std::int32_t>(get(4)); }
  float f32() RT_SAFE { return std::bit_cast<float>(get(4)); }
  /// Whether all bytes from here to `end` are zero.
  bool zeros_until(std::size_t end) RT_SAFE {
    std::uint32_t any = 0;
    while (at_ < end) any |= bytes_[at_++];
    return any == 0;
  }

 private:
  std::uint32_t get(int size) RT_SAFE {
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) value |= std::uint32_t{bytes_[at_++]} << (8 * i);
    return value;
  }
  ReportBytes bytes_;
  std::size_t at_ = 0;
};

}  // namespace trocar::hid
