// SPDX-License-Identifier: Apache-2.0
#include "cli/process_pool.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>
#include <vector>

extern "C" {  // glibc 2.36 forgot it
#include <sys/pidfd.h>
}

namespace trocar::cli {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail_by_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// A file descriptor, closed in the end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int operator*() const { return number_; }

 private:
  int number_;
};

/// A file in memory that a child writes and its parent reads.
Descriptor shared_file(const char* name) {
  const int file = ::memfd_create(name, 0);
  if (file < 0) fail_by_errno("memfd_create");
  return Descriptor(file);
}

std::string content(const Descriptor& file) {
  std::string text(static_cast<std::size_t>(std::max<off_t>(::lseek(*file, 0, SEEK_END), 0)), '\0');
  std::size_t got = 0;
  while (got < text.size()) {
    const ssize_t count =
        ::pread(*file, text.data() + got, text.size() - got, static_cast<off_t>(got));
    if (count <= 0) break;
    got += static_cast<std::size_t>(count);
  }
  text.resize(got);
  return text;
}

void write_all(int file, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t count = ::write(file, text.data() + at, text.size() - at);
    if (count < 0) std::_Exit(EXIT_FAILURE);
    at += static_cast<std::size_t>(count);
  }
}

struct Child {
  std::size_t index;
  pid_t process;
  Descriptor watch;  // readable once it has ended
  Descriptor answer;
  Descriptor output;
  Clock::time_point began;
};

Child start(std::size_t index, const std::function<std::string(std::size_t)>& task) {
  Descriptor answer = shared_file("answer"), output = shared_file("output");
  std::fflush(nullptr);  // else the copy would print what waits here
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process < 0) fail_by_errno("fork");
  if (process == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) std::_Exit(EXIT_FAILURE);
    ::dup2(*output, STDOUT_FILENO);
    ::dup2(*output, STDERR_FILENO);
    write_all(*answer, task(index));
    std::fflush(nullptr);
    std::_Exit(EXIT_SUCCESS);
  }
  const int watch = ::pidfd_open(process, 0);
  if (watch < 0) fail_by_errno("pidfd_open");
  return {index, process, Descriptor(watch), std::move(answer), std::move(output), Clock::now()};
}

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

ProcessOutcome collect(const Child& child, double timeout, bool killed) {
  int status = 0;
  if (::waitpid(child.process, &status, 0) < 0) fail_by_errno("waitpid");
  ProcessOutcome outcome{.answer = content(child.answer),
                         .output = content(child.output),
                         .seconds = seconds_since(child.began)};
  if (killed)
    outcome.trouble = fmt::format("did not end within {:g} s", timeout);
  else if (WIFSIGNALED(status))
    outcome.trouble =
        fmt::format("ended by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  else if (WEXITSTATUS(status) != EXIT_SUCCESS)
    outcome.trouble = fmt::format("ended with status {}", WEXITSTATUS(status));
  return outcome;
}

/// Waits until one has ended, or has to. @return its place, and whether it was killed
std::pair<std::size_t, bool> wait_for_one(const std::vector<Child>& children, double timeout) {
  for (;;) {
    std::vector<pollfd> watched;
    double left = timeout;
    for (const Child& child : children) {
      watched.push_back({*child.watch, POLLIN, 0});
      left = std::min(left, timeout - seconds_since(child.began));
    }
    constexpr double longest = 1000.0;  // [s]
    const int patience = static_cast<int>(1000.0 * std::clamp(left, 0.0, longest)) + 1;
    if (::poll(watched.data(), watched.size(), patience) < 0 && errno != EINTR)
      fail_by_errno("poll");
    for (std::size_t i = 0; i < watched.size(); ++i)
      if (watched[i].revents != 0) return {i, false};
    for (std::size_t i = 0; i < children.size(); ++i)
      if (seconds_since(children[i].began) >= timeout) {
        ::kill(children[i].process, SIGKILL);
        return {i, true};
      }
  }
}

}  // namespace

void run_in_processes(std::size_t count, const ProcessOptions& options,
                      const std::function<std::string(std::size_t)>& task,
                      const std::function<void(std::size_t, ProcessOutcome)>& done) {
  const long processors = std::max(::sysconf(_SC_NPROCESSORS_ONLN), 1L);
  const std::size_t at_once =
      options.at_once > 0 ? options.at_once : static_cast<std::size_t>(processors);
  std::vector<Child> children;
  std::size_t next = 0;
  while (next < count || !children.empty()) {
    while (next < count && children.size() < at_once) children.push_back(start(next++, task));
    const auto [place, killed] = wait_for_one(children, options.timeout);
    const Child child = std::move(children[place]);
    children.erase(children.begin() + static_cast<std::ptrdiff_t>(place));
    done(child.index, collect(child, options.timeout, killed));
  }
}

}  // namespace trocar::cli
