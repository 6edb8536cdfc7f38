// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/file_series.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace trocar {
namespace {

constexpr int most_files = 10'000;

/// Whether something stands there already; else an empty file does now. What cannot be created for
/// another reason is for its writer to complain about.
bool exists(const std::string& path) {
  if (std::FILE* file = std::fopen(path.c_str(), "wx")) {
    std::fclose(file);
    return false;
  }
  return errno == EEXIST;
}

}  // namespace

FileSeries::FileSeries(const std::string& first, Existing existing) : existing_(existing) {
  const std::filesystem::path path(first);
  extension_ = path.extension().string();
  stem_ = first.substr(0, first.size() - extension_.size());
  if (!stem_.ends_with("-1")) return;
  stem_.resize(stem_.size() - 2);
  first_is_numbered_ = true;
}

std::string FileSeries::name(int number) const {
  if (number == 1 && !first_is_numbered_) return stem_ + extension_;
  return fmt::format("{}-{}{}", stem_, number, extension_);
}

std::string FileSeries::next() {
  while (number_ <= most_files) {
    const std::string path = name(number_++);
    if (existing_ == Existing::replaced || !exists(path)) return path;
  }
  throw std::runtime_error(
      fmt::format("\"{}\" and {} files named after it are there already", name(1), most_files - 1));
}

}  // namespace trocar
