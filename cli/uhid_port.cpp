// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <linux/uhid.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "cli/device_port.hpp"

namespace trocar::cli {
namespace {

/// Vendor page, 64 bytes in and 64 bytes out without report numbers: docs/device-protocol.md.
constexpr std::array<std::uint8_t, 25> descriptor{
    0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75,
    0x08, 0x95, 0x40, 0x09, 0x02, 0x81, 0x02, 0x09, 0x03, 0x91, 0x02, 0xC0};

template <std::size_t Size>
void put_text(__u8 (&field)[Size], const std::string& text) {
  std::memcpy(field, text.data(), std::min(text.size(), Size - 1));
}

class UhidPort final : public DevicePort {
 public:
  UhidPort(const std::string& path, const UhidIdentity& identity)
      : path_(path),
        identity_(identity),
        file_(open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC)) {
    if (file_ < 0)
      throw std::runtime_error(
          fmt::format("{} cannot be opened ({}): it needs the kernel's module uhid (sudo modprobe "
                      "uhid), and its rights",
                      path, std::strerror(errno)));
    plug();
  }
  ~UhidPort() override { close(file_); }  // takes the device away
  UhidPort(const UhidPort&) = delete;
  UhidPort& operator=(const UhidPort&) = delete;

  std::size_t receive(std::span<std::uint8_t> into) override {
    uhid_event event{};
    while (read(file_, &event, sizeof event) > 0) {
      if (event.type == UHID_OUTPUT) return take(event.u.output, into);
      refuse_feature(event);
    }
    return 0;
  }

  void send(const hid::Report& report) override {
    if (!plugged_) return;
    uhid_event event{};
    event.type = UHID_INPUT2;
    event.u.input2.size = static_cast<__u16>(report.size());
    std::copy(report.begin(), report.end(), event.u.input2.data);
    write_event(event, offsetof(uhid_event, u.input2.data) + report.size());
  }

  void plug() override {
    if (plugged_) return;
    uhid_event event{};
    event.type = UHID_CREATE2;
    uhid_create2_req& create = event.u.create2;
    put_text(create.name, "Trocar laparoscope");
    put_text(create.uniq, identity_.serial);
    create.rd_size = descriptor.size();
    create.bus = BUS_USB;
    create.vendor = identity_.vendor;
    create.product = identity_.product;
    std::copy(descriptor.begin(), descriptor.end(), create.rd_data);
    if (!write_event(event, sizeof event))
      throw std::runtime_error(fmt::format("{} makes no device: {}", path_, std::strerror(errno)));
    plugged_ = true;
  }

  void unplug() override {
    if (!plugged_) return;
    uhid_event event{};
    event.type = UHID_DESTROY;
    write_event(event, sizeof event);
    plugged_ = false;
  }

 private:
  bool write_event(const uhid_event& event, std::size_t size) {
    return write(file_, &event, size) == static_cast<ssize_t>(size);
  }

  /// The kernel hands on the report's number before it, 0 where the device has none.
  static std::size_t take(const uhid_output_req& output, std::span<std::uint8_t> into) {
    const std::size_t skip = output.size == hid::report_size + 1 && output.data[0] == 0 ? 1 : 0;
    const std::size_t size = std::min<std::size_t>(output.size - skip, into.size());
    std::copy_n(output.data + skip, size, into.begin());
    return size;
  }

  /// It has no feature reports; without an answer who asks waits for 5 s.
  void refuse_feature(const uhid_event& asked) {
    uhid_event reply{};
    if (asked.type == UHID_GET_REPORT) {
      reply.type = UHID_GET_REPORT_REPLY;
      reply.u.get_report_reply.id = asked.u.get_report.id;
      reply.u.get_report_reply.err = EIO;
    } else if (asked.type == UHID_SET_REPORT) {
      reply.type = UHID_SET_REPORT_REPLY;
      reply.u.set_report_reply.id = asked.u.set_report.id;
      reply.u.set_report_reply.err = EIO;
    } else {
      return;
    }
    write_event(reply, sizeof reply);
  }

  std::string path_;
  UhidIdentity identity_;
  int file_;
  bool plugged_ = false;
};

}  // namespace

std::unique_ptr<DevicePort> uhid_port(const std::string& path, const UhidIdentity& identity) {
  return std::make_unique<UhidPort>(path, identity);
}

}  // namespace trocar::cli
