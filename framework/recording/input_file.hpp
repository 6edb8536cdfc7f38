// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace trocar {

/// A file that is read at places one names; its size is the one it had when opened.
class InputFile {
 public:
  /// @throw std::runtime_error when it cannot be opened or is no regular file.
  explicit InputFile(std::string path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Fills `into` with the bytes from `offset` on.
  /// @throw std::runtime_error when the file has fewer, or the disk reports an error.
  void read(std::uint64_t offset, std::span<std::byte> into) const;

  std::uint64_t size() const { return size_; }  // [B]
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::uint64_t size_ = 0;
  int descriptor_ = -1;
};

}  // namespace trocar
