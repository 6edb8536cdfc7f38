// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace trocar {
namespace {

std::string reason(int error) {
  return std::generic_category().message(error);
}

std::string cure(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "free space on that disk, or record to another one";
    case EFBIG:
      return "raise the limit of file size (ulimit -f), or record for a shorter time";
    case ENOENT:
      return "create the folder first";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a folder that you may write to";
    case EISDIR:
      return "give the name of a file in that folder";
    default:
      return "check the disk, or record to another one";
  }
}

/// Writes all of `bytes`; returns 0, or the error number.
int write_all(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor_ < 0) {
    const int error = errno;
    throw std::runtime_error("cannot create '" + path_ + "': " + reason(error) + "; " +
                             cure(error));
  }
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::require_good() const {
  if (failed()) throw std::runtime_error(failure_);
  if (!is_open()) throw std::logic_error("'" + path_ + "' is closed already");
}

void OutputFile::append(std::initializer_list<std::span<const std::byte>> parts) {
  require_good();
  std::uint64_t size = size_;
  std::uint32_t crc = crc_;
  for (const std::span<const std::byte> part : parts) {
    if (const int error = write_all(descriptor_, part)) fail(error);
    size += part.size();
    crc = crc32(part, crc);
  }
  size_ = size;
  crc_ = crc;
}

void OutputFile::sync() {
  if (failed()) throw std::runtime_error(failure_);
  if (!is_open()) return;
  // Pipes and some special files have nothing to wait for.
  if (::fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail(errno);
}

void OutputFile::close() {
  if (!is_open()) return;
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    const int error = errno;
    failure_ = "cannot finish '" + path_ + "': " + reason(error) + "; " + cure(error);
    throw std::runtime_error(failure_);
  }
}

void OutputFile::fail(int error) {
  failure_ = "cannot write '" + path_ + "' after " + std::to_string(size_) +
             " bytes: " + reason(error) + "; " + cure(error) + "; what was written stays readable";
  // Best effort: a torn piece at the end would only be skipped by readers.
  [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, static_cast<off_t>(size_));
  throw std::runtime_error(failure_);
}

}  // namespace trocar
