// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/input_layout.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace trocar::hid {
namespace {

constexpr int largest_report = 1024;  // of a USB endpoint [bytes]

[[noreturn]] void refuse(const InputField& field, const std::string& what) {
  throw std::invalid_argument("field \"" + field.name + "\": " + what);
}

void require(const InputField& field) {
  if (field.name.empty())
    throw std::invalid_argument("a field at bit " + std::to_string(field.bit) +
                                " has no name; give it one");
  if (field.report < 0 || field.report > 255)
    refuse(field, "report is " + std::to_string(field.report) +
                      "; numbers are 1 to 255, and 0 for a device without");
  if (field.bits < 1 || field.bits > 32)
    refuse(field, "bits is " + std::to_string(field.bits) + "; a field has 1 to 32");
  const int first = field.report == 0 ? 0 : 8;
  if (field.bit < first || field.bit > 8 * largest_report - field.bits)
    refuse(field, "bit is " + std::to_string(field.bit) + "; from " + std::to_string(first) +
                      (first == 8 ? " (the first 8 are the report's number)" : "") + " to " +
                      std::to_string(8 * largest_report - field.bits));
  if (!std::isfinite(field.scale) || field.scale == 0.0 || !std::isfinite(field.centre))
    refuse(field, "scale " + std::to_string(field.scale) + " and centre " +
                      std::to_string(field.centre) + " must be finite, and scale not zero");
}

std::size_t bytes_needed(const InputField& field) RT_SAFE {
  return static_cast<std::size_t>(field.bit + field.bits + 7) / 8;
}

double raw(const InputField& field, std::span<const std::uint8_t> bytes) RT_SAFE {
  const auto first = static_cast<std::size_t>(field.bit) / 8;
  std::uint64_t number = 0;
  for (std::size_t i = first; i < bytes_needed(field); ++i)
    number |= std::uint64_t{bytes[i]} << (8 * (i - first));
  number = number >> (field.bit % 8) & ((std::uint64_t{1} << field.bits) - 1);
  const bool negative = field.is_signed && (number >> (field.bits - 1) & 1) != 0;
  const auto value = static_cast<double>(number);
  return negative ? value - static_cast<double>(std::uint64_t{1} << field.bits) : value;
}

}  // namespace

InputLayout::InputLayout(std::vector<InputField> fields) : fields_(std::move(fields)) {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    require(fields_[i]);
    for (std::size_t k = 0; k < i; ++k) {
      if (fields_[k].name == fields_[i].name) refuse(fields_[i], "there are two of this name");
      if ((fields_[k].report == 0) != (fields_[i].report == 0))
        refuse(fields_[i], "\"" + fields_[k].name +
                               "\" has another idea of whether the device numbers its reports");
    }
  }
}

bool InputLayout::decode(std::span<const std::uint8_t> bytes,
                         std::span<double> values) const RT_SAFE {
  if (bytes.empty() || values.size() < fields_.size()) return false;
  const auto is_here = [&](const InputField& field) {
    return field.report == 0 || field.report == bytes[0];
  };
  bool any = false;
  for (const InputField& field : fields_) {
    if (!is_here(field)) continue;
    if (bytes.size() < bytes_needed(field)) return false;
    any = true;
  }
  for (std::size_t i = 0; i < fields_.size(); ++i)
    if (is_here(fields_[i]))
      values[i] = fields_[i].scale * (raw(fields_[i], bytes) - fields_[i].centre);
  return any;
}

}  // namespace trocar::hid
