// SPDX-License-Identifier: Apache-2.0
#include "framework/finding.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trocar {

namespace {

constexpr std::size_t longest_message = 2000;  // [B]: a script may quote anything

}  // namespace

std::string Where::text() const {
  return line > 0 ? fmt::format("{}:{}", file, line) : file;
}

std::string Finding::text() const {
  const std::string at = where.text();
  return at.empty() ? message : at + ": " + message;
}

void Findings::add(const Where& where, std::string message) {
  if (message.size() > longest_message) {
    std::size_t cut = longest_message;
    while (cut > 0 && (static_cast<unsigned char>(message[cut]) & 0xc0) == 0x80) --cut;
    message.replace(cut, std::string::npos, "…");
  }
  const bool known = std::any_of(all_.begin(), all_.end(), [&](const Finding& finding) {
    return finding.where == where && finding.message == message;
  });
  if (!known) all_.push_back({where, std::move(message)});
}

Findings Findings::by_line() const {
  const auto file = [this](const Finding& finding) {
    return std::find_if(all_.begin(), all_.end(), [&](const Finding& other) {
      return other.where.file == finding.where.file;
    });
  };
  Findings sorted = *this;
  std::stable_sort(sorted.all_.begin(), sorted.all_.end(), [&](const Finding& a, const Finding& b) {
    return std::pair(file(a), a.where.line) < std::pair(file(b), b.where.line);
  });
  return sorted;
}

std::string Findings::text() const {
  std::string result;
  for (const Finding& finding : all_) result += finding.text() + "\n";
  return result;
}

}  // namespace trocar
