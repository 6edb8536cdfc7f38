// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>

#include "framework/recording/crc32.hpp"

namespace trocar {

/// A file that only grows, keeps the CRC-32 of all its bytes, and after a failed
/// write ends where the last whole piece ended.
class OutputFile {
 public:
  /// Creates `path`, or empties the file that is there.
  /// @throw std::runtime_error when it cannot be opened.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends all parts as one piece, or none of them.
  /// @throw std::runtime_error with path, reason and cure; so does every later call.
  void append(std::initializer_list<std::span<const std::byte>> parts);

  /// @throw std::runtime_error after a failed write, std::logic_error after close().
  void require_good() const;

  /// Waits until the disk has what was appended.
  /// @throw std::runtime_error when the disk reports an error.
  void sync();

  /// @throw std::runtime_error when the file system reports a late write error.
  void close();

  bool is_open() const { return descriptor_ >= 0; }
  bool failed() const { return !failure_.empty(); }
  std::uint64_t size() const { return size_; }  // [B]
  std::uint32_t crc() const { return crc_; }
  const std::string& path() const { return path_; }

 private:
  [[noreturn]] void fail(int error);

  std::string path_;
  std::string failure_;
  std::uint64_t size_ = 0;
  std::uint32_t crc_ = 0;
  int descriptor_ = -1;
};

}  // namespace trocar
