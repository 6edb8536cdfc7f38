// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <stdexcept>

#include "components/devices/hid/device_line.hpp"
#include "components/devices/hid/emulated_laparoscope.hpp"
#include "components/devices/hid/pipe_link.hpp"
#include "components/devices/hid/report_faults.hpp"
#include "framework/time_source.hpp"

namespace trocar::test {

/// Emulated devices, each at the other end of a pipe, in the virtual time of one thread: nothing
/// moves but when the time does.
class EmulatedBench final : public TimeSource {
 public:
  struct Unit {
    hid::EmulatedLaparoscope device;
    hid::ReportFaults faults{7};
    std::unique_ptr<hid::PipeLink> end{};
    bool plugged = true;
    bool deaf = false;  // what the host sends is lost
    std::int64_t started_ns = 0, cycles = 0;
    std::int64_t silent_ns = 0;     // since when no motor has any effort; 0 while one has
    std::int64_t last_sent_ns = 0;  // when the last report arrived at the host

    explicit Unit(const hid::EmulatedLaparoscopeSettings& settings) : device(settings) {}
  };

  static hid::EmulatedLaparoscopeSettings settings(std::uint32_t serial) {
    hid::EmulatedLaparoscopeSettings settings{.serial = serial};
    settings.plant.start = {{0.004, -0.003, 0.080}, 0.0, 0.0, 0.0};
    settings.power_up_us = 0xFFFF'FFFF - 3'000'000;  // wraps soon
    settings.first_sequence = 0xFF00;
    return settings;
  }

  Unit& add(const hid::EmulatedLaparoscopeSettings& settings) {
    Unit& unit = units.emplace_back(settings);
    unit.started_ns = now_ns_;
    return unit;
  }
  std::int64_t now() RT_SAFE override { return now_ns_; }
  void sleep_until(std::int64_t date_ns) RT_SAFE override { advance_to(date_ns); }
  void advance_to(std::int64_t date_ns) {
    while (now_ns_ < date_ns) {
      now_ns_ = std::min(date_ns, now_ns_ + 250'000);
      for (Unit& unit : units)
        while (unit.started_ns + (unit.cycles + 1) * unit.device.cycle_us() * 1000 <= now_ns_)
          cycle(unit);
    }
  }
  void unplug(Unit& unit) {
    unit.plugged = false;
    unit.end.reset();
  }
  /// Power was gone.
  void plug(Unit& unit) {
    unit.device.power_cycle();
    unit.faults.clear();
    unit.plugged = true;
  }

  std::deque<Unit> units;

 private:
  void cycle(Unit& unit) {
    ++unit.cycles;
    std::array<std::uint8_t, 128> bytes{};
    while (unit.end != nullptr) {
      const int size = unit.end->read(bytes, 0);
      if (size <= 0) break;
      if (!unit.deaf) unit.device.receive({bytes.data(), static_cast<std::size_t>(size)});
    }
    unit.device.cycle();
    const bool silent = unit.device.effort().isZero();
    unit.silent_ns = !silent ? 0 : unit.silent_ns != 0 ? unit.silent_ns : now_ns_;
    hid::Report report;
    while (unit.device.next(report)) unit.faults.send(report, unit.device.time_us());
    while (unit.faults.arrived(unit.device.time_us(), report))
      if (unit.end != nullptr) {
        unit.end->write(report);
        unit.last_sent_ns = now_ns_;
      }
  }

  std::int64_t now_ns_ = 1'000'000'000;
};

/// While it waits, the bench's time goes on.
class BenchLink final : public hid::Link {
 public:
  BenchLink(EmulatedBench& bench, std::unique_ptr<hid::PipeLink> pipe)
      : bench_(bench), pipe_(std::move(pipe)) {}
  int read(std::span<std::uint8_t> into, int timeout_ms) override {
    const std::int64_t end = bench_.now() + std::int64_t{timeout_ms} * 1'000'000;
    int size = pipe_->read(into, 0);
    while (size == 0 && bench_.now() < end) {
      bench_.advance_to(bench_.now() + 250'000);
      size = pipe_->read(into, 0);
    }
    return size;
  }
  bool write(hid::ReportBytes report) override { return pipe_->write(report); }

 private:
  EmulatedBench& bench_;
  std::unique_ptr<hid::PipeLink> pipe_;
};

/// Plugs a pipe into the unit of a serial.
class BenchSource final : public hid::LinkSource {
 public:
  BenchSource(EmulatedBench& bench, std::string serial)
      : bench_(bench), serial_(std::move(serial)) {}
  hid::LinkPair open() override {
    for (EmulatedBench::Unit& unit : bench_.units) {
      const bool fits =
          serial_ == "any" || serial_ == std::to_string(unit.device.pages().identity.serial);
      if (!fits || !unit.plugged) continue;
      auto [host, device] = hid::PipeLink::make_pair();
      unit.end = std::move(device);
      auto second = host->second();
      return {std::make_unique<BenchLink>(bench_, std::move(host)),
              std::make_unique<BenchLink>(bench_, std::move(second))};
    }
    throw std::runtime_error("no emulated device has serial " + serial_);
  }

 private:
  EmulatedBench& bench_;
  std::string serial_;
};

}  // namespace trocar::test
