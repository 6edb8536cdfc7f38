// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/input_layout.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace trocar::hid {
namespace {

std::size_t bytes_needed(const InputField& field) RT_SAFE {
  return static_cast<std::size_t>(field.offset + field.bits + 7) / 8;
}

double raw(const InputField& field, std::span<const std::uint8_t> bytes) RT_SAFE {
  const auto first = static_cast<std::size_t>(field.offset) / 8;
  std::uint64_t number = 0;
  for (std::size_t i = first; i < bytes_needed(field); ++i)
    number |= std::uint64_t{bytes[i]} << (8 * (i - first));
  number = number >> (field.offset % 8) & ((std::uint64_t{1} << field.bits) - 1);
  const bool negative = field.is_signed && (number >> (field.bits - 1) & 1) != 0;
  const auto value = static_cast<double>(number);
  return negative ? value - static_cast<double>(std::uint64_t{1} << field.bits) : value;
}

[[noreturn]] void refuse(const InputField& field, const std::string& what) {
  throw std::invalid_argument(fmt::format("field \"{}\": {}", field.name, what));
}

}  // namespace

std::string trouble_with(const InputField& field, int bytes) {
  if (field.report < 0 || field.report > 255)
    return fmt::format("report = {}: numbers are 1 to 255, and 0 for a device without",
                       field.report);
  if (field.bits < 1 || field.bits > 32)
    return fmt::format("bits = {}: a field has 1 to 32", field.bits);
  if (field.offset < 0) return fmt::format("offset = {}: bits count from 0", field.offset);
  if (field.report != 0 && field.offset < 8)
    return fmt::format("offset = {}: from 8, since the first 8 bits are the report's number",
                       field.offset);
  if (bytes_needed(field) > static_cast<std::size_t>(bytes))
    return fmt::format("offset = {}: {} bits from there end in byte {} of a report of {}",
                       field.offset, field.bits, bytes_needed(field), bytes);
  if (!std::isfinite(field.scale) || field.scale == 0.0)
    return fmt::format("scale = {}: must be finite, and not zero", field.scale);
  if (!std::isfinite(field.centre)) return fmt::format("centre = {}: must be finite", field.centre);
  return "";
}

std::string trouble_between(const InputField& first, const InputField& second) {
  if ((first.report == 0) != (second.report == 0))
    return fmt::format("report = {}: \"{}\" has {}; a device numbers all its reports, or none",
                       second.report, first.name, first.report);
  if (first.report == second.report && first.offset < second.offset + second.bits &&
      second.offset < first.offset + first.bits)
    return fmt::format("bits {} to {} of report {} overlap with \"{}\", {} to {}", second.offset,
                       second.offset + second.bits - 1, second.report, first.name, first.offset,
                       first.offset + first.bits - 1);
  return "";
}

InputLayout::InputLayout(std::vector<InputField> fields, int bytes)
    : fields_(std::move(fields)), bytes_(bytes) {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const InputField& field = fields_[i];
    if (field.name.empty())
      throw std::invalid_argument(
          fmt::format("the field at bit {} has no name; give it one", field.offset));
    if (const std::string wrong = trouble_with(field, bytes); !wrong.empty()) refuse(field, wrong);
    for (std::size_t k = 0; k < i; ++k) {
      if (fields_[k].name == field.name) refuse(field, "there are two of this name");
      if (const std::string wrong = trouble_between(fields_[k], field); !wrong.empty())
        refuse(field, wrong);
    }
  }
}

bool InputLayout::decode(std::span<const std::uint8_t> bytes,
                         std::span<double> values) const RT_SAFE {
  if (bytes.empty() || values.size() < fields_.size()) return false;
  bool any = false;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (!holds(bytes, i)) continue;
    if (bytes.size() < bytes_needed(fields_[i])) return false;
    any = true;
  }
  for (std::size_t i = 0; i < fields_.size(); ++i)
    if (holds(bytes, i))
      values[i] = fields_[i].scale * (raw(fields_[i], bytes) - fields_[i].centre);
  return any;
}

}  // namespace trocar::hid
