// SPDX-License-Identifier: Apache-2.0
#include "framework/finding.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trocar {

std::string Where::text() const {
  return line > 0 ? fmt::format("{}:{}", file, line) : file;
}

std::string Finding::text() const {
  const std::string at = where.text();
  return at.empty() ? message : at + ": " + message;
}

void Findings::add(const Where& where, std::string message) {
  const bool known = std::any_of(all_.begin(), all_.end(), [&](const Finding& finding) {
    return finding.where == where && finding.message == message;
  });
  if (!known) all_.push_back({where, std::move(message)});
}

std::string Findings::text() const {
  std::string result;
  for (const Finding& finding : all_) result += finding.text() + "\n";
  return result;
}

}  // namespace trocar
