// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <vector>

#include "cli/commands.hpp"
#include "cli/output.hpp"

namespace trocar::cli {
namespace {

struct WatchRequest {
  std::string url = "ws://127.0.0.1:8765";
  bool json = false, list = false, stop = false;
  std::vector<std::string> patterns;
  double interval = 0.0, seconds = 0.0;
};

/// "lab:9000" is ws://lab:9000.
std::string checked_url(std::string url) {
  if (url.find("://") == std::string::npos) url = "ws://" + url;
  if (!url.starts_with("ws://") && !url.starts_with("wss://"))
    throw CLI::ValidationError(
        "URL", fmt::format("{} is no address of a live stream: ws://127.0.0.1:8765 is one",
                           in_quotes(url)));
  return url;
}

std::vector<std::string> words_of(const WatchRequest& request) {
  std::vector<std::string> words = {"trocar-watch"};
  if (request.json) words.emplace_back("--json");
  if (request.list) words.emplace_back("--list");
  if (request.stop) words.emplace_back("--stop");
  for (const std::string& pattern : request.patterns) {
    words.emplace_back("--signals");
    words.push_back(pattern);
  }
  if (request.interval > 0) words.push_back(fmt::format("--interval={}", request.interval));
  if (request.seconds > 0) words.push_back(fmt::format("--for={}", request.seconds));
  words.emplace_back("--");
  words.push_back(checked_url(request.url));
  return words;
}

/// Becomes the other program, which has Qt; returns only when that cannot be.
void become(std::vector<std::string> words) {
  std::error_code none;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", none);
  const std::string program = (self.parent_path() / words.front()).string();
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execv(program.c_str(), arguments.data());
  throw std::runtime_error(fmt::format("{} cannot be started: {}", program, std::strerror(errno)));
}

}  // namespace

void add_watch(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("watch", "Watch a run that is served, on a terminal or as JSON lines");
  const auto request = std::make_shared<WatchRequest>();
  command->add_option("url", request->url, "Where `trocar run --serve` listens")
      ->capture_default_str()
      ->type_name("URL");
  command->add_flag("--json", request->json, "A JSON object a line: link, state, values, event");
  CLI::Option* list =
      command->add_flag("--list", request->list, "List the signals with their values, then leave");
  command
      ->add_flag("--stop", request->stop,
                 "Stop the rendering, then leave: 0 when that is confirmed, 1 when not")
      ->excludes(list);
  command
      ->add_option("--signals", request->patterns,
                   "Only these: a part of a name, or a pattern with * and ?")
      ->type_name("PATTERN");
  command->add_option("--interval", request->interval, "Time between values [s]")
      ->check(CLI::Range(0.05, 3600.0));
  command->add_option("--for", request->seconds, "Leave after that time [s]")
      ->check(CLI::Range(0.1, 1e7));
  command->footer(
      "Examples:\n  trocar watch\n"
      "  trocar watch ws://lab:8765 --signals wall.force --json\n"
      "  trocar watch --stop\n"
      "To stop needs no token. On a terminal space stops, a acknowledges, q leaves.");
  command->callback([request] { become(words_of(*request)); });
}

}  // namespace trocar::cli
