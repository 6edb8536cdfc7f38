// SPDX-License-Identifier: Apache-2.0
#include "cli/emulator.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "framework/text.hpp"
#include "framework/units.hpp"

namespace trocar::cli {
namespace {

const std::vector<std::string> order_words{"corrupt", "dead-man", "deaf",  "delay",
                                           "heat",    "jump",     "loss",  "plug",
                                           "quit",    "state",    "stuck", "unplug"};

double share(const std::string& text, const std::string& order) {
  try {
    const double value = parse_quantity(text).value;
    if (parse_quantity(text).unit.dimension == parse_unit("%").dimension && value >= 0.0 &&
        value <= 1.0)
      return value;
  } catch (const UnitError&) {
  }
  throw std::invalid_argument(
      fmt::format("{} \"{}\": a share from 0 % to 100 % is needed", order, text));
}

std::uint32_t microseconds(const std::string& text, const std::string& order) {
  constexpr double longest = 10.0;  // [s]
  try {
    const Quantity time = parse_quantity(text);
    if (time.unit.dimension == parse_unit("s").dimension && time.value >= 0.0 &&
        time.value <= longest)
      return static_cast<std::uint32_t>(std::lround(time.value * 1e6));
  } catch (const UnitError&) {
  }
  throw std::invalid_argument(
      fmt::format("{} \"{}\": a time from 0 s to {} s is needed", order, text, longest));
}

bool switched(const std::string& text, const std::string& order) {
  if (text == "on" || text == "off") return text == "on";
  throw std::invalid_argument(fmt::format("{} \"{}\": on or off is possible", order, text));
}

int whole(const std::string& text, int lowest, int highest, const char* what) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end || value < lowest || value > highest)
    throw std::invalid_argument(fmt::format("{} \"{}\": a whole number from {} to {} is needed",
                                            what, text, lowest, highest));
  return value;
}

/// The first word, and the rest.
std::pair<std::string, std::string> split_off(std::string_view text) {
  text = trim(text);
  const std::size_t space = std::min(text.find(' '), text.size());
  return {std::string(text.substr(0, space)), std::string(trim(text.substr(space)))};
}

const char* name_of(hid::DeviceState state) {
  constexpr std::array names{"unhomed", "homing", "ready", "engaged", "fault"};
  return names[static_cast<std::size_t>(state)];
}

const char* name_of(hid::DeviceFault fault) {
  constexpr std::array names{"none", "watchdog", "encoder jump", "temperature", "speed", "homing"};
  return names[static_cast<std::size_t>(fault)];
}

}  // namespace

const char* Emulator::orders() {
  return "  loss 20%          reports that never arrive      delay 3ms    that they are late\n"
         "  corrupt 5%        reports with a bit turned      stuck on     the last one again\n"
         "  deaf on           commands never arrive          jump 2 4000  counts of an axis\n"
         "  heat 130          of the motors, in degrees C    heat off     as they are\n"
         "  dead-man off      released                       state        what it does now\n"
         "  unplug, plug      power is lost                  quit";
}

void Emulator::cycle() {
  std::array<std::uint8_t, 256> bytes{};
  for (std::size_t size = port_.receive(bytes); size > 0; size = port_.receive(bytes))
    if (!deaf_) receive({bytes.data(), size});
  device_.cycle();
  effort_end_.cycle(!device_.effort().isZero(), device_.time_us());
  hid::Report report;
  while (device_.next(report)) faults_.send(report, device_.time_us());
  while (faults_.arrived(device_.time_us(), report)) {
    port_.send(report);
    if (plugged_) effort_end_.report_left(report, device_.time_us());
  }
}

void Emulator::receive(hid::ReportBytes bytes) {
  const std::uint32_t before = device_.intake().taken();
  device_.receive(bytes);
  if (device_.intake().taken() != before) effort_end_.command_taken(device_.time_us());
}

void Emulator::plug(bool plugged) {
  if (plugged == plugged_) return;
  if (plugged) {
    device_.power_cycle();
    faults_.clear();
    effort_end_.forget();
    port_.plug();
  } else {
    port_.unplug();
  }
  plugged_ = plugged;
}

std::string Emulator::state() const {
  const hid::DeviceStateMachine& machine = device_.machine();
  const Eigen::Vector3d tip = device_.plant().configuration().tool.tip * 1e3;
  const Vector6d effort = device_.effort();
  const std::string end = effort_end_.text();
  return fmt::format(
      "{}{}{}, tip {:.2f} {:.2f} {:.2f} mm, sliders {:.2f} {:.2f} {:.2f} N, {} commands taken{}{}",
      name_of(machine.state()),
      machine.fault() == hid::DeviceFault::none ? ""
                                                : std::string(" of ") + name_of(machine.fault()),
      device_.braked() ? ", braked" : "", tip.x(), tip.y(), tip.z(), effort[0], effort[1],
      effort[2], device_.intake().taken(), end.empty() ? "" : ", ", end);
}

std::string Emulator::obey(std::string_view line) {
  const auto [order, rest] = split_off(line);
  hid::ReportFaultOrders& way = faults_.orders;
  if (order == "loss") {
    way.loss = share(rest, order);
  } else if (order == "corrupt") {
    way.corruption = share(rest, order);
  } else if (order == "delay") {
    way.delay_us = microseconds(rest, order);
  } else if (order == "stuck") {
    way.stuck = switched(rest, order);
  } else if (order == "deaf") {
    deaf_ = switched(rest, order);
  } else if (order == "dead-man") {
    device_.press_dead_man(switched(rest, order));
  } else if (order == "jump") {
    const auto [axis, counts] = split_off(rest);
    const int which = whole(axis, 1, 6, "jump: axis");
    device_.jump(static_cast<std::size_t>(which - 1),
                 whole(counts, -8'000'000, 8'000'000, "jump: counts"));
  } else if (order == "heat") {
    device_.heat(rest == "off" ? -300.0 : whole(rest, -40, 200, "heat"));
  } else if (order == "plug" || order == "unplug") {
    plug(order == "plug");
  } else if (order == "quit") {
    over_ = true;
  } else if (order == "state") {
    return state();
  } else if (!order.empty()) {
    throw std::invalid_argument(fmt::format("there is no order \"{}\"{}; possible are\n{}", order,
                                            suggestion(order, order_words), orders()));
  }
  return "";
}

}  // namespace trocar::cli
