// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/commands.hpp"
#include "cli/emulator.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/script_options.hpp"
#include "components/devices/hid/attached_devices.hpp"
#include "components/devices/simulated_laparoscope.hpp"
#include "framework/clock.hpp"
#include "framework/realtime/loop_thread.hpp"

namespace trocar::cli {
namespace {

struct EmulateArguments {
  std::string socket, gadget, controller, uhid;
  std::uint32_t serial = 1;
  std::string vendor = "1209", product = "0001";
  std::string period, duration;
  std::uint64_t seed = 1;
  std::vector<std::string> settings, orders;
};

/// Lines of standard input, as they come. Its end ends nothing: in a shell's background there is no
/// input at all.
class Orders {
 public:
  std::optional<std::string> next() {
    fill();
    const std::size_t end = text_.find('\n');
    if (end == std::string::npos) return std::nullopt;
    std::string line = text_.substr(0, end);
    text_.erase(0, end + 1);
    return line;
  }

 private:
  void fill() {
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    if (ended_ || poll(&input, 1, 0) != 1) return;
    std::array<char, 256> some{};
    const ssize_t size = read(STDIN_FILENO, some.data(), some.size());
    ended_ = size <= 0;
    if (size > 0) text_.append(some.data(), static_cast<std::size_t>(size));
  }
  std::string text_;
  bool ended_ = false;
};

void set_parameter(SimulatedLaparoscope& plant, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  const std::string name = setting.substr(0, equals);
  ParameterBase* parameter = plant.find_parameter(name);
  if (equals == std::string::npos || parameter == nullptr)
    throw CLI::ValidationError(
        "--set", fmt::format("{} sets no parameter of SimulatedLaparoscope, e.g. hand=push "
                             "(trocar describe SimulatedLaparoscope)",
                             in_quotes(setting)));
  if (const std::string wrong = parameter->set(literal_from_text(setting.substr(equals + 1)));
      !wrong.empty())
    throw CLI::ValidationError("--set", fmt::format("{} {}", name, wrong));
}

/// Of state reports: a whole number of the firmware's cycles, as slow as a host may be.
std::uint32_t period_us(const std::string& text, std::uint32_t cycle_us) {
  constexpr double slowest = 4000.0;
  const double us = duration_of(text, "--period") * 1e6;
  const double cycles = std::round(us / cycle_us);
  if (us > slowest + 0.5 || cycles < 1.0 || std::abs(us - cycles * cycle_us) > 0.5)
    throw CLI::ValidationError("--period",
                               fmt::format("{} is no whole number of {} us up to 4 ms, e.g. 2ms",
                                           in_quotes(text), cycle_us));
  return static_cast<std::uint32_t>(cycles) * cycle_us;
}

hid::EmulatedLaparoscopeSettings device_settings(const EmulateArguments& arguments) {
  SimulatedLaparoscope plant;
  for (const std::string& setting : arguments.settings) set_parameter(plant, setting);
  hid::EmulatedLaparoscopeSettings settings{.plant = plant.plant_settings({.seed = arguments.seed}),
                                            .serial = arguments.serial};
  if (!arguments.period.empty())
    settings.period_us = period_us(arguments.period, settings.cycle_us);
  return settings;
}

std::unique_ptr<DevicePort> port_of(const EmulateArguments& arguments) {
  if (!arguments.socket.empty()) return socket_port(arguments.socket);
  if (!arguments.gadget.empty()) return gadget_port(arguments.gadget, arguments.controller);
  if (!arguments.uhid.empty())
    return uhid_port(arguments.uhid, {.vendor = hid::usb_number(arguments.vendor, "--vendor"),
                                      .product = hid::usb_number(arguments.product, "--product"),
                                      .serial = std::to_string(arguments.serial)});
  throw CLI::ValidationError("emulate", "say where: --socket FILE, --gadget FILE or --uhid");
}

void carry_out(Emulator& emulator, const std::string& line) {
  try {
    if (const std::string said = emulator.obey(line); !said.empty()) print(said + "\n");
    std::fflush(stdout);
  } catch (const std::exception& error) {
    complain(error.what());
  }
}

/// Device time keeps up with the machine's: cycles that were missed are made up for.
void run_in_real_time(Emulator& emulator, std::optional<double> duration) {
  constexpr int cycles_between_orders = 40;
  const StopFlag& stop = stop_on_interrupt();
  Orders orders;
  PeriodicClock clock;
  clock.start(std::int64_t{emulator.device().cycle_us()} * 1000);
  const std::int64_t last =
      duration ? std::llround(*duration * 1e6 / emulator.device().cycle_us()) : -1;
  for (std::int64_t done = 0; !emulator.over() && !stop.raised() && done != last;) {
    const std::int64_t due = clock.wait().index + 1;
    for (; done < due && done != last; ++done) {
      emulator.cycle();
      if (done % cycles_between_orders != 0) continue;
      while (const auto line = orders.next()) carry_out(emulator, *line);
    }
  }
}

int emulate(const EmulateArguments& arguments) {
  const std::unique_ptr<DevicePort> port = port_of(arguments);
  Emulator emulator(device_settings(arguments), *port);
  for (const std::string& order : arguments.orders) {
    try {
      emulator.obey(order);
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError("--order", error.what());
    }
  }
  const std::optional<double> duration =
      arguments.duration.empty() ? std::nullopt
                                 : std::optional(duration_of(arguments.duration, "--for"));
  print(fmt::format("emulated laparoscope, serial {}; orders on standard input:\n{}\n",
                    arguments.serial, Emulator::orders()));
  std::fflush(stdout);  // whoever orders through pipes waits for it
  for (const std::string& missing : run_on_loop_thread(
           {.name = "firmware", .realtime = true}, [&] { run_in_real_time(emulator, duration); }))
    complain("not real-time: " + missing);
  print(emulator.obey("state") + "\n");
  return success;
}

}  // namespace

void add_emulate(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("emulate", "Emulate the laparoscope behind its USB protocol");
  const auto arguments = std::make_shared<EmulateArguments>();
  CLI::Option* socket =
      command->add_option("--socket", arguments->socket, "Listen at this path for a driver");
  CLI::Option* gadget = command->add_option("--gadget", arguments->gadget,
                                            "Be the function of a USB gadget, e.g. /dev/hidg0");
  CLI::Option* uhid =
      command->add_option("--uhid", arguments->uhid, "Make a device of the kernel by /dev/uhid");
  for (CLI::Option* where : {socket, gadget, uhid})
    where->check(check_file_name)->type_name("FILE");
  socket->excludes(gadget)->excludes(uhid);
  gadget->excludes(uhid);
  command
      ->add_option("--udc", arguments->controller,
                   "The gadget's file UDC, for the orders plug and unplug of --gadget")
      ->check(check_file_name)
      ->type_name("FILE")
      ->needs(gadget);
  command->add_option("--serial", arguments->serial, "Of the device (default 1)");
  command->add_option("--vendor", arguments->vendor, "Of USB, with --uhid (default 1209)");
  command->add_option("--product", arguments->product, "Of USB, with --uhid (default 0001)");
  command
      ->add_option("--set", arguments->settings,
                   "A parameter of SimulatedLaparoscope, e.g. hand=push or ideal=true")
      ->allow_extra_args(false);
  command->add_option("--seed", arguments->seed, "Of what differs between devices (default 1)");
  command
      ->add_option("--order", arguments->orders,
                   "What is to go wrong from the beginning, e.g. \"loss 10%\"")
      ->allow_extra_args(false);
  command->add_option("--period", arguments->period,
                      "Between two state reports, e.g. 2ms (default 1ms)");
  command->add_option("--for", arguments->duration, "How long, e.g. 5s (default: until Ctrl-C)");
  command->footer(fmt::format(
      "Example, in two terminals:\n"
      "  trocar emulate --socket laparoscope.sock --set hand=push\n"
      "  trocar run scripts/tutorial/01_feel_a_wall.lua --set laparoscope.device=hid \\\n"
      "    --set laparoscope.path=laparoscope.sock        (then h homes, e engages)\n"
      "Orders, a line each on standard input:\n{}\n"
      "Exit status: 0 success, 1 the port cannot be had, 2 wrong usage.",
      Emulator::orders()));
  command->callback([arguments, &status] { status = emulate(*arguments); });
}

}  // namespace trocar::cli
