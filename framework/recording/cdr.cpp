// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/cdr.hpp"

#include <limits>
#include <string>

namespace trocar {

CdrWriter::CdrWriter(std::vector<std::byte>& into) : bytes_(&into) {
  into.assign({std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}});
}

void CdrWriter::append(const void* data, std::size_t size, std::size_t alignment) {
  bytes_->resize(cdr_align(bytes_->size(), alignment));
  const auto* first = static_cast<const std::byte*>(data);
  bytes_->insert(bytes_->end(), first, first + size);
}

void CdrWriter::string(std::string_view text) {
  if (text.size() >= std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("CDR: a string must be shorter than 4 GiB");
  number(static_cast<std::uint32_t>(text.size() + 1));
  append(text.data(), text.size(), 1);
  number(std::uint8_t{0});
}

CdrReader::CdrReader(std::span<const std::byte> bytes, std::size_t offset)
    : bytes_(bytes), offset_(offset) {
  if (bytes.size() < cdr_head || bytes[0] != std::byte{0} || bytes[1] != std::byte{1})
    throw std::runtime_error("CDR: the message does not begin with 00 01 (little-endian CDR)");
}

const std::byte* CdrReader::take(std::size_t size, std::size_t alignment) {
  const std::size_t start = cdr_align(offset_, alignment);
  if (start > bytes_.size() || size > bytes_.size() - start)
    throw std::runtime_error("CDR: " + std::to_string(size) + " bytes should stand at byte " +
                             std::to_string(start) + " of the message, which has " +
                             std::to_string(bytes_.size()));
  offset_ = start + size;
  return bytes_.data() + start;
}

std::string_view CdrReader::string() {
  const auto length = number<std::uint32_t>();
  const auto* text = reinterpret_cast<const char*>(take(length, 1));
  if (length == 0) return {};  // some writers leave the closing zero out
  if (text[length - 1] != '\0')
    throw std::runtime_error("CDR: the string that ends at byte " + std::to_string(offset_) +
                             " of the message has no closing zero");
  return {text, length - 1};
}

}  // namespace trocar
