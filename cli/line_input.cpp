// SPDX-License-Identifier: Apache-2.0
#include "cli/line_input.hpp"

#include <editline/readline.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

namespace trocar::cli {
namespace {

constexpr int longest_history = 1000;  // lines

// The library has callbacks without a context.
std::optional<std::string> typed;
bool typed_end = false;
const LineInput::Complete* completing = nullptr;

void take_line(char* line) {
  if (line == nullptr) {
    typed_end = true;
    return;
  }
  typed = line;
  if (*line != '\0') add_history(line);
  std::free(line);
}

/// The library asks for the next candidate until it gets none; `state` is 0 for the first.
char* next_candidate(const char* begin, int state) {
  static std::vector<std::string> candidates;
  static std::size_t next = 0;
  if (state == 0) {
    candidates = completing == nullptr ? std::vector<std::string>() : (*completing)(begin);
    next = 0;
  }
  return next < candidates.size() ? ::strdup(candidates[next++].c_str()) : nullptr;
}

char** complete_word(const char* begin, int start, int) {
  rl_attempted_completion_over = 1;  // no file names
  rl_completion_append_character = '\0';
  return start > 0 ? nullptr : rl_completion_matches(begin, next_candidate);
}

/// In the folder for what programs remember; "" when there is none.
std::string history_file() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  std::filesystem::path folder;
  if (state != nullptr && *state != '\0')
    folder = state;
  else if (home != nullptr && *home != '\0')
    folder = std::filesystem::path(home) / ".local/state";
  else
    return "";
  std::error_code error;
  std::filesystem::create_directories(folder / "trocar", error);
  return error ? "" : (folder / "trocar/history").string();
}

}  // namespace

LineInput::LineInput(std::string prompt)
    : prompt_(std::move(prompt)), terminal_(::isatty(STDIN_FILENO) != 0) {}

LineInput::~LineInput() {
  close_terminal();
}

void LineInput::open_terminal() {
  opened_ = true;
  typed.reset();
  typed_end = false;
  rl_readline_name = const_cast<char*>("trocar");
  rl_attempted_completion_function = complete_word;
  using_history();
  stifle_history(longest_history);
  if (const std::string file = history_file(); !file.empty()) read_history(file.c_str());
  rl_callback_handler_install(prompt_.c_str(), take_line);
}

void LineInput::close_terminal() {
  if (!opened_) return;
  opened_ = false;
  rl_callback_handler_remove();
  if (const std::string file = history_file(); !file.empty()) write_history(file.c_str());
}

bool LineInput::readable() const {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  return ::poll(&input, 1, 0) == 1 && input.revents != 0;
}

std::optional<std::string> LineInput::next_of_pipe() {
  for (;;) {
    if (const std::size_t end = piped_.find('\n'); end != std::string::npos) {
      std::string line = piped_.substr(0, end);
      piped_.erase(0, end + 1);
      return line;
    }
    if (!readable()) return std::nullopt;
    char part[256];
    const ssize_t count = ::read(STDIN_FILENO, part, sizeof part);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return std::nullopt;
    if (count <= 0) {
      closed_ = true;
      if (piped_.empty()) return std::nullopt;
      return std::exchange(piped_, std::string());
    }
    piped_.append(part, static_cast<std::size_t>(count));
  }
}

std::optional<std::string> LineInput::next(const Complete& complete) {
  if (closed_) return std::nullopt;
  if (!terminal_) return next_of_pipe();
  if (!opened_) open_terminal();
  // The library shows its prompt when a line begins, and not behind what was printed meanwhile.
  if (std::exchange(answered_, false)) rl_callback_handler_install(prompt_.c_str(), take_line);
  completing = &complete;
  while (!typed && !typed_end && readable()) rl_callback_read_char();
  completing = nullptr;
  if (typed_end) {
    closed_ = true;
    close_terminal();
  }
  answered_ = typed.has_value();
  return std::exchange(typed, std::nullopt);
}

}  // namespace trocar::cli
