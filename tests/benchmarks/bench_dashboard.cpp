// SPDX-License-Identifier: Apache-2.0
// Whether the loop feels the dashboard: the lateness of scripts/tutorial/01_feel_a_wall.lua at 1
// kHz in real time with the dashboard attached and drawing, stopped by SIGSTOP, killed, and without
// it, in turn.
//
//   bench_dashboard [ROUNDS [SECONDS]]     10 rounds of 5 s by default
//
// The dashboard is a process of its own, as always, without a display.
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "components/register.hpp"
#include "framework/scripting/script.hpp"
#include "framework/session.hpp"
#include "plugins/foxglove/foxglove_service.hpp"

using namespace trocar;

namespace {

enum class Fate { absent, attached, stopped, killed };

pid_t start_dashboard(const std::string& url) {
  const auto self = std::filesystem::read_symlink("/proc/self/exe");
  const std::string program = self.parent_path() / "trocar-dashboard";
  std::string words[] = {program, "--connect", url};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  posix_spawn_file_actions_addopen(&quiet, STDERR_FILENO, "/dev/null", 1, 0);  // 1: O_WRONLY
  pid_t process = 0;
  if (posix_spawn(&process, program.c_str(), &quiet, nullptr, arguments, environ) != 0) {
    fmt::print(stderr, "{} is missing: build the target trocar-dashboard\n", program);
    std::exit(1);
  }
  posix_spawn_file_actions_destroy(&quiet);
  return process;
}

/// [ns] of lateness at 50 and 99 %.
std::pair<double, double> lateness(double seconds, Fate fate) {
  Registry registry;
  register_components(registry);
  foxglove::FoxgloveService service(ServiceType::Settings{{"address", "127.0.0.1:0"}});
  pid_t dashboard = 0;
  if (fate != Fate::absent) dashboard = start_dashboard(service.endpoint().url());
  SessionOptions options;
  options.duration = seconds + 1.0;
  options.services = {&service};
  options.write_files = false;
  options.print_to_stderr = true;
  bool met = fate == Fate::absent || fate == Fate::attached;
  options.operator_input = [&](RunControl& control) {
    if (!met && control.time() > 1.0) {
      kill(dashboard, fate == Fate::stopped ? SIGSTOP : SIGKILL);
      met = true;
    }
    return false;
  };
  usleep(1'500'000);  // it starts and connects
  Session session(registry, options);
  run_script(session, TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua");
  session.finish();
  if (dashboard != 0) {
    kill(dashboard, SIGKILL);
    waitpid(dashboard, nullptr, 0);
  }
  const TimingHistogram& all = session.runs().front()->result.main().loop.lateness;
  return {static_cast<double>(all.percentile(0.5)), static_cast<double>(all.percentile(0.99))};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 10;
  const double seconds = argc > 2 ? std::atof(argv[2]) : 5.0;
  setenv("QT_QPA_PLATFORM", "offscreen", 1);
  struct Case {
    const char* name;
    Fate fate;
    std::vector<double> p50{}, p99{};  // ratios to the round without
  };
  std::vector<Case> cases = {{"none, again", Fate::absent},
                             {"attached", Fate::attached},
                             {"stopped by SIGSTOP", Fate::stopped},
                             {"killed", Fate::killed}};
  for (int i = 0; i < rounds; ++i) {
    const auto [p50, p99] = lateness(seconds, Fate::absent);
    fmt::print("round {:2}: none {:5.1f} / {:6.1f} µs", i + 1, p50 * 1e-3, p99 * 1e-3);
    for (Case& one : cases) {
      const auto with = lateness(seconds, one.fate);
      one.p50.push_back(with.first / p50);
      one.p99.push_back(with.second / p99);
      fmt::print(", {}: {:.2f} / {:.2f}", one.name, one.p50.back(), one.p99.back());
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
  fmt::print(
      "\nratios of the loop's lateness to that without a dashboard: median (least to greatest)   "
      "target <= 1.15\n");
  for (const Case& one : cases) {
    const auto [low50, high50] = std::minmax_element(one.p50.begin(), one.p50.end());
    const auto [low99, high99] = std::minmax_element(one.p99.begin(), one.p99.end());
    fmt::print("  {:20} p50 {:.2f} ({:.2f} to {:.2f})   p99 {:.2f} ({:.2f} to {:.2f})\n", one.name,
               median(one.p50), *low50, *high50, median(one.p99), *low99, *high99);
  }
  return 0;
}
