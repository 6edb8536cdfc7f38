// SPDX-License-Identifier: Apache-2.0
#include "framework/command.hpp"

#include <algorithm>
#include <iterator>

namespace trocar {
namespace {

struct Request {
  const char* name;
  Command::Kind kind;
};

constexpr Request requests[] = {{"stop", Command::Kind::stop_rendering},
                                {"acknowledge", Command::Kind::acknowledge},
                                {"home", Command::Kind::home},
                                {"engage", Command::Kind::engage},
                                {"end", Command::Kind::end}};

}  // namespace

std::optional<Command::Kind> request_named(std::string_view name) {
  const auto found = std::find_if(std::begin(requests), std::end(requests),
                                  [&](const Request& one) { return name == one.name; });
  return found == std::end(requests) ? std::nullopt : std::optional(found->kind);
}

const char* request_name(Command::Kind kind) {
  const auto found = std::find_if(std::begin(requests), std::end(requests),
                                  [&](const Request& one) { return kind == one.kind; });
  return found == std::end(requests) ? "" : found->name;
}

std::vector<std::string> request_names() {
  std::vector<std::string> names;
  for (const Request& one : requests) names.emplace_back(one.name);
  return names;
}

}  // namespace trocar
