// SPDX-License-Identifier: Apache-2.0
// From the key to the device's echo, end to end and without a display:
//
//   bench_stop [ROUNDS [SCRIPT.lua]]     20 rounds of tutorial 01 by default
//
// Each round starts the dashboard's window with a runtime of its own, presses F12 once it renders,
// and waits for the row in which nothing is rendered any more, as the operator's window does. It
// prints a line a round, and the median. Exit status: 0 when each stop was confirmed within the
// 250 ms after which the window gives up, else 1.
#include <fmt/format.h>

#include <QApplication>
#include <QTest>
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <vector>

#include "gui/app/dashboard.hpp"
#include "gui/pages/start_page.hpp"

using namespace trocar::gui;

namespace {

constexpr int patience_ms = 20'000;

/// [s], or nothing when it was not confirmed in time.
std::optional<double> stop_once(const QString& script) {
  Dashboard dashboard;
  dashboard.run(script, {"--clock", "realtime", "--black-box", "off"});
  dashboard.window().show();
  const auto engaged = [&] { return dashboard.operators().status().state == RunState::engaged; };
  if (!QTest::qWaitFor(engaged, patience_ms)) return std::nullopt;
  StopControl& stop = dashboard.operators().stop_control();
  QTest::keyClick(&dashboard.window(), Qt::Key_F12);
  const auto judged = [&] { return stop.state() != StopControl::State::stopping; };
  if (!QTest::qWaitFor(judged, patience_ms) || stop.state() != StopControl::State::confirmed)
    return std::nullopt;
  return stop.confirmed_after();
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication app(argc, argv);
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 20;
  const QString script = argc > 2 ? argv[2] : shipped_script("tutorial/01_feel_a_wall.lua");
  std::vector<double> times;
  int failed = 0;
  for (int round = 1; round <= rounds; ++round) {
    const std::optional<double> time = stop_once(script);
    fmt::print("round {}: {}\n", round,
               time ? fmt::format("{:.1f} ms", 1e3 * *time) : std::string("not confirmed"));
    if (time)
      times.push_back(*time);
    else
      ++failed;
  }
  if (times.empty()) return 1;
  std::sort(times.begin(), times.end());
  fmt::print(
      "key to echo: median {:.1f} ms, least {:.1f} ms, most {:.1f} ms, of {}; not confirmed {}\n",
      1e3 * times[times.size() / 2], 1e3 * times.front(), 1e3 * times.back(), times.size(), failed);
  return failed == 0 ? 0 : 1;
}
