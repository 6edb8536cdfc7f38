// SPDX-License-Identifier: Apache-2.0
// Whether the loop waits for the device: lateness of a loop at 1 kHz whose driver writes at once,
// and of one whose every write takes 5 ms, in turn. The device is emulated, in a thread of this
// process, at the other end of a socket.
//
//   bench_hid [ROUNDS]     20 by default, 4 s each
//
// Of each round the ratio of percentiles counts; its median is printed, with the spread.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "cli/emulator.hpp"
#include "components/devices/hid/device_line.hpp"
#include "components/devices/hid/pipe_link.hpp"
#include "components/devices/hid_laparoscope.hpp"
#include "components/register.hpp"
#include "framework/realtime/service_thread.hpp"
#include "framework/run.hpp"
#include "framework/time_source.hpp"

using namespace trocar;

namespace {

constexpr auto slow_write = std::chrono::milliseconds(5);
constexpr std::array shares{0.5, 0.99};

class SlowLink final : public hid::Link {
 public:
  explicit SlowLink(std::unique_ptr<hid::Link> link) : link_(std::move(link)) {}
  int read(std::span<std::uint8_t> into, int timeout_ms) override {
    return link_->read(into, timeout_ms);
  }
  bool write(hid::ReportBytes report) override {
    std::this_thread::sleep_for(slow_write);
    return link_->write(report);
  }

 private:
  std::unique_ptr<hid::Link> link_;
};

class SlowSource final : public hid::LinkSource {
 public:
  explicit SlowSource(const std::string& path) : source_(path) {}
  hid::LinkPair open() override {
    hid::LinkPair pair = source_.open();
    return {std::move(pair.in), std::make_unique<SlowLink>(std::move(pair.out))};
  }

 private:
  hid::SocketSource source_;
};

class SlowLaparoscope final : public HidLaparoscope {
 protected:
  std::unique_ptr<hid::DeviceLine> line(const hid::DeviceLineSettings& settings) override {
    static MonotonicTime time;
    return std::make_unique<hid::DeviceLine>(std::make_unique<SlowSource>(*which.path), time,
                                             settings);
  }
};

/// Keeps up with the machine's time.
class EmulatedDevice {
 public:
  explicit EmulatedDevice(const std::string& path) : port_(cli::socket_port(path)) {}

 private:
  void run(const StopFlag& stop) {
    PeriodicClock clock;
    clock.start(std::int64_t{emulator_.device().cycle_us()} * 1000);
    for (std::int64_t done = 0; !stop.raised();)
      for (const std::int64_t due = clock.wait().index; done <= due; ++done) emulator_.cycle();
  }
  std::unique_ptr<cli::DevicePort> port_;
  cli::Emulator emulator_{{}, *port_};
  ServiceThread thread_{"device", [this](const StopFlag& stop) { run(stop); }};
};

RunResult run_once(const std::string& path, bool slow) {
  Registry all, registry;
  register_components(all);
  for (ComponentType type : all.types()) {
    if (slow && type.name == "HidLaparoscope")
      type.make = [] { return std::make_unique<SlowLaparoscope>(); };
    registry.add(std::move(type));
  }
  Graph graph(registry);
  const Where where{"bench", 1};
  const NodeId group = *graph.add("Laparoscope", "", where);
  graph.set({group, "device"}, {std::string("hid")}, where);
  graph.set({group, "path"}, {path}, where);
  graph.build_group(group);
  RunOptions options{.clock = ClockKind::realtime, .duration = 2.0};
  options.timing.overload.policy = OverloadPolicy::ignore;
  for (const double at : {0.0, 0.2})
    options.requests.push_back({.at = at, .kind = Command::Kind::home});
  return run(graph, options);
}

struct Percentiles {
  std::vector<double> at_once, slow, ratio;
};

double share_of(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 20;
  const std::string path =
      std::filesystem::temp_directory_path() / fmt::format("trocar-bench-{}.sock", getpid());
  std::array<Percentiles, shares.size()> found;
  {
    EmulatedDevice device(path);
    for (int round = 0; round < rounds; ++round) {
      const bool slow_first = round % 2 != 0;
      const RunResult first = run_once(path, slow_first), second = run_once(path, !slow_first);
      const TimingHistogram& at_once = (slow_first ? second : first).main().loop.lateness;
      const TimingHistogram& slow = (slow_first ? first : second).main().loop.lateness;
      for (std::size_t i = 0; i < shares.size(); ++i) {
        const auto a = static_cast<double>(at_once.percentile(shares[i]));
        const auto b = static_cast<double>(slow.percentile(shares[i]));
        found[i].at_once.push_back(1e-3 * a);
        found[i].slow.push_back(1e-3 * b);
        found[i].ratio.push_back(b / a);
      }
    }
  }
  std::filesystem::remove(path);
  fmt::print("lateness of a loop at 1 kHz with a device, {} rounds\n", rounds);
  fmt::print("{:<6}{:>18}{:>20}{:>10}\n", "", "write at once [us]", "write in 5 ms [us]", "ratio");
  for (std::size_t i = 0; i < shares.size(); ++i)
    fmt::print("p{:<5.0f}{:>18.1f}{:>20.1f}{:>10.2f}   ({:.2f} to {:.2f})   target <= 1.15\n",
               100.0 * shares[i], share_of(found[i].at_once, 0.5), share_of(found[i].slow, 0.5),
               share_of(found[i].ratio, 0.5), share_of(found[i].ratio, 0.1),
               share_of(found[i].ratio, 0.9));
}
