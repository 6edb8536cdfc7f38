// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/hidapi_link.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <hidapi.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "components/devices/hid/hidapi_lock.hpp"
#include "components/devices/hid/udev_rule.hpp"

namespace trocar::hid {

Exclusive& hidapi_lock() {
  static Exclusive lock;
  return lock;
}

HidapiLink::HidapiLink(const std::string& path)
    : device_(hidapi_lock().run([&] { return hid_open_path(path.c_str()); })) {
  if (device_ == nullptr) throw std::runtime_error(path + " cannot be opened by hidapi");
}

HidapiLink::~HidapiLink() {
  hid_close(device_);
}

int HidapiLink::read(std::span<std::uint8_t> into, int timeout_ms) {
  const int size = hid_read_timeout(device_, into.data(), into.size(), timeout_ms);
  return size < 0 ? gone : size;
}

/// The byte before the report is its number, and 0 where a device has none; it is not sent.
bool HidapiLink::write(ReportBytes report) {
  std::array<std::uint8_t, 1 + report_size> numbered{};
  const std::size_t size = std::min(report.size(), report_size);
  std::copy_n(report.begin(), size, numbered.begin() + 1);
  return hid_write(device_, numbered.data(), size + 1) >= 0;
}

std::string opening_failed(const AttachedDevice& device, int error) {
  const std::string what =
      fmt::format("{} may not be opened ({})", device.text(), std::strerror(error));
  if (error == EACCES || error == EPERM)
    return fmt::format(
        "{}: write this line into /etc/udev/rules.d/70-trocar.rules, then run "
        "\"sudo udevadm control --reload && sudo udevadm trigger\":\n"
        "  {}",
        what, udev_rule(device.vendor, device.product));
  if (error == EWOULDBLOCK)
    return fmt::format("{} is in use: by another trocar, or twice in this script; give each {}",
                       device.text(), "device its own serial");
  return what;
}

HidapiSource::~HidapiSource() {
  if (claim_ >= 0) close(claim_);
}

/// hidraw gives a device to all who open it, so a lock on its file says whose it is.
void HidapiSource::claim(const AttachedDevice& device) {
  if (claim_ >= 0) close(claim_);
  claim_ = ::open(device.path.c_str(), O_RDWR | O_CLOEXEC);
  if (claim_ >= 0 && flock(claim_, LOCK_EX | LOCK_NB) == 0) return;
  const int error = errno;
  if (claim_ >= 0) close(claim_);
  claim_ = -1;
  throw std::runtime_error(opening_failed(device, error));
}

/// Two handles, since hidapi keeps the last error with each, without a lock.
LinkPair HidapiSource::open() {
  const std::vector<AttachedDevice> attached = attached_devices();
  const AttachedDevice& device = selected(selection_, attached);
  claim(device);
  return {std::make_unique<HidapiLink>(device.path), std::make_unique<HidapiLink>(device.path)};
}

}  // namespace trocar::hid
