// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "framework/realtime/rt_safe.hpp"

namespace trocar::hid {

constexpr int largest_report = 1024;  // of a USB endpoint [bytes]

/// One number in an input report, as a HID report descriptor describes it.
///
///   value = scale (raw - centre)
struct InputField {
  std::string name;
  int report = 0;  // its number, the first byte of the report; 0: the device does not number
  int offset = 0;  // bit where it begins, from the report's first byte, the number included
  int bits = 8;    // 1 to 32
  bool is_signed = false;  // two's complement
  double centre = 0.0;
  double scale = 1.0;
};

/// What is wrong with a field, with the value and what is allowed, or "".
/// @param bytes of the longest report
std::string trouble_with(const InputField& field, int bytes);
/// Why two fields cannot be in one layout, said of the second, or "".
std::string trouble_between(const InputField& first, const InputField& second);

/// Decodes input reports of any HID device by a list of fields. Bits count as in HID 1.11, 5.6 and
/// 8.4: upwards from the lowest of the first byte, numbers little-endian across bytes.
class InputLayout {
 public:
  /// @throw std::invalid_argument for a field without a name or with that of another, a bit or a
  /// number of bits out of range, a field in the number itself, fields that share a bit, a scale
  /// that is not finite or zero, or numbered and unnumbered reports in one layout
  explicit InputLayout(std::vector<InputField> fields, int bytes = largest_report);

  const std::vector<InputField>& fields() const { return fields_; }
  /// Of the longest report, as the device sends it.
  int bytes() const { return bytes_; }

  /// Writes the values of the fields that this report holds; the others keep theirs.
  /// @param bytes as hid_read() gives them
  /// @param values one for each field
  /// @return whether it was one of the layout's reports and long enough for all its fields;
  /// if not, nothing is written
  bool decode(std::span<const std::uint8_t> bytes, std::span<double> values) const RT_SAFE;
  /// Whether reports that begin as this one hold the field.
  bool holds(std::span<const std::uint8_t> bytes, std::size_t field) const RT_SAFE {
    return fields_[field].report == 0 || (!bytes.empty() && fields_[field].report == bytes[0]);
  }

 private:
  std::vector<InputField> fields_;
  int bytes_;
};

}  // namespace trocar::hid
