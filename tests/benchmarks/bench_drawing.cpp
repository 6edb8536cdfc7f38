// SPDX-License-Identifier: Apache-2.0
// What a frame of the dashboard's plots costs: 4 plots of 6 curves over 10 s of a loop at 10 kHz,
// in a window of 1280 by 720, fed by batches as the stream sends them, their decoding included.
//
//   build/bin/bench_drawing [FRAMES]     300 by default; QT_QPA_PLATFORM=offscreen without a
//   display
//
// The time is the processor's, of the thread that draws. What the frame's rows are made from is
// made before.
#include <fmt/format.h>
#include <time.h>

#include <QApplication>
#include <QGridLayout>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "framework/clock.hpp"
#include "framework/stream/batch.hpp"
#include "gui/plots/time_plot.hpp"
#include "tests/gui/track_rig.hpp"

using namespace trocar;

namespace {

constexpr int plots = 4, curves = 6;
constexpr std::int64_t rows_a_batch = 100, batches_a_frame = 3;  // some 30 ms

double thread_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double noisy(std::size_t i, std::int64_t tick) {
  const auto t = static_cast<double>(tick);
  return std::sin(6e-4 * t + static_cast<double>(i)) + 0.1 * std::sin(2.3 * t);
}

/// As Batch makes them: the head, the number of rows, then the rows.
std::vector<std::byte> batch(const test::TrackRig& rig, std::int64_t from) {
  std::vector<std::byte> message(12);
  message[1] = std::byte{1};
  const auto count = static_cast<std::uint32_t>(rows_a_batch);
  std::memcpy(message.data() + 4, &count, sizeof count);
  std::vector<double> values(plots * curves);
  for (std::int64_t tick = from; tick < from + rows_a_batch; ++tick) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = noisy(i, tick);
    const auto row = rig.row({.tick = tick, .time = tick * 100'000}, values);
    message.insert(message.end(), row.begin(), row.end());
  }
  return message;
}

double share(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

}  // namespace

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  const int frames = argc > 1 ? std::max(1, std::atoi(argv[1])) : 300;
  std::vector<std::string> names;
  for (int i = 0; i < plots * curves; ++i) names.push_back("signal" + std::to_string(i));
  test::TrackRig rig(names);

  QWidget window;
  window.resize(1280, 720);
  auto* grid = new QGridLayout(&window);
  std::vector<gui::TimePlot*> views;
  for (int i = 0; i < plots; ++i) {
    views.push_back(new gui::TimePlot(rig.store));
    for (int k = 0; k < curves; ++k)
      views.back()->add_curve(names[static_cast<std::size_t>(curves * i + k)]);
    grid->addWidget(views.back(), i / 2, i % 2);
  }
  window.show();

  std::int64_t tick = 0;
  const auto feed = [&](const std::vector<std::byte>& message) {
    for (const auto row : stream::Batch::rows(message, rig.track->row_size())) rig.track->add(row);
  };
  for (; tick < 100'000; tick += rows_a_batch) feed(batch(rig, tick));

  std::vector<double> costs;
  const std::int64_t begin = monotonic_ns();
  double making = 0.0;  // of what the stream would send
  for (int frame = 0; frame < frames; ++frame) {
    const std::int64_t making_begin = monotonic_ns();
    std::vector<std::vector<std::byte>> messages;
    for (int i = 0; i < batches_a_frame; ++i, tick += rows_a_batch)
      messages.push_back(batch(rig, tick));
    making += 1e-9 * static_cast<double>(monotonic_ns() - making_begin);
    const double before = thread_time();
    for (const auto& message : messages) feed(message);
    for (gui::TimePlot* view : views) view->refresh();
    app.processEvents();
    costs.push_back(1e3 * (thread_time() - before));
  }
  const double seconds = 1e-9 * static_cast<double>(monotonic_ns() - begin) - making;
  fmt::print("{} plots of {} curves, 10 s at 10 kHz, 1280 x 720, {}: {} frames\n", plots, curves,
             app.platformName().toStdString(), frames);
  fmt::print("processor time of a frame: median {:.1f} ms, 99 % {:.1f} ms   target <= 10 ms\n",
             share(costs, 0.5), share(costs, 0.99));
  fmt::print("as fast as it can: {:.0f} frames/s   target >= 30\n", frames / seconds);
  return 0;
}
