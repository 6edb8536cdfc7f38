// SPDX-License-Identifier: Apache-2.0
#include "cli/device_port.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "components/devices/hid/pipe_link.hpp"

namespace trocar::cli {
namespace {

[[noreturn]] void port_failed(const std::string& path, const char* cure) {
  throw std::runtime_error(
      fmt::format("{} cannot be used ({}): {}", path, std::strerror(errno), cure));
}

std::string first_line(const std::string& path) {
  std::string line;
  std::ifstream file(path);
  if (!file) port_failed(path, "it is a gadget's file UDC");
  std::getline(file, line);
  return line;
}

/// In one call of write, as the files of a file system of settings want it.
void write_line(const std::string& path, std::string line) {
  line += '\n';
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  const bool written =
      file >= 0 && ::write(file, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  const int error = errno;
  if (file >= 0) close(file);
  errno = error;
  if (!written) port_failed(path, "it is a gadget's file UDC, and only root may write to it");
}

bool is_socket(const std::string& path) {
  struct stat found {};
  return lstat(path.c_str(), &found) == 0 && S_ISSOCK(found.st_mode);
}

class SocketPort final : public DevicePort {
 public:
  explicit SocketPort(std::string path) : path_(std::move(path)) { plug(); }
  ~SocketPort() override { unplug(); }
  SocketPort(const SocketPort&) = delete;
  SocketPort& operator=(const SocketPort&) = delete;

  std::size_t receive(std::span<std::uint8_t> into) override {
    accept_host();
    if (host_ == nullptr) return 0;
    const int size = host_->read(into, 0);
    if (size == hid::Link::gone) host_.reset();
    return size > 0 ? static_cast<std::size_t>(size) : 0;
  }
  void send(const hid::Report& report) override {
    if (host_ != nullptr && !host_->write(report)) host_.reset();
  }

  /// A socket that somebody left behind is taken over; another file is not.
  void plug() override {
    if (listening_ >= 0) return;
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    errno = ENAMETOOLONG;
    if (path_.size() >= sizeof address.sun_path) port_failed(path_, "take a shorter path");
    std::memcpy(address.sun_path, path_.c_str(), path_.size());
    listening_ = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (listening_ < 0) port_failed(path_, "no socket can be made");
    if (is_socket(path_) && !somebody_listens(address)) ::unlink(path_.c_str());
    if (bind(listening_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
        listen(listening_, 1) == 0)
      return;
    close_listening();
    port_failed(path_, "take a path that is free, in a folder that may be written");
  }

  void unplug() override {
    host_.reset();
    if (listening_ < 0) return;
    close_listening();
    ::unlink(path_.c_str());
  }

 private:
  static bool somebody_listens(const sockaddr_un& address) {
    const int file = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const bool answered = file >= 0 && connect(file, reinterpret_cast<const sockaddr*>(&address),
                                               sizeof address) == 0;
    if (file >= 0) ::close(file);
    return answered;
  }
  void close_listening() {
    const int error = errno;
    ::close(listening_);
    listening_ = -1;
    errno = error;
  }
  /// A second host finds its end closed.
  void accept_host() {
    if (listening_ < 0) return;
    const int file = accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
    if (file < 0) return;
    auto host = std::make_unique<hid::PipeLink>(file);
    if (host_ == nullptr) host_ = std::move(host);
  }

  std::string path_;
  int listening_ = -1;
  std::unique_ptr<hid::PipeLink> host_;
};

class GadgetPort final : public DevicePort {
 public:
  GadgetPort(std::string path, std::string controller)
      : path_(std::move(path)), controller_(std::move(controller)) {
    if (!controller_.empty()) udc_ = first_line(controller_);
    if (!controller_.empty() && udc_.empty())
      throw std::runtime_error(controller_ +
                               " names no controller: plug the gadget in before, by writing the "
                               "name of one of /sys/class/udc into it");
    open_file();
  }
  ~GadgetPort() override {
    if (file_ >= 0) close(file_);
  }
  GadgetPort(const GadgetPort&) = delete;
  GadgetPort& operator=(const GadgetPort&) = delete;

  std::size_t receive(std::span<std::uint8_t> into) override {
    const ssize_t size = read(file_, into.data(), into.size());
    return size > 0 ? static_cast<std::size_t>(size) : 0;
  }
  void send(const hid::Report& report) override {
    [[maybe_unused]] const ssize_t sent = ::write(file_, report.data(), report.size());
  }

  void plug() override {
    require_controller();
    write_line(controller_, udc_);
    open_file();
  }
  /// The function's file goes away with the plug; who keeps it open keeps the old one.
  void unplug() override {
    require_controller();
    close(file_);
    file_ = -1;
    write_line(controller_, "");
  }

 private:
  void require_controller() const {
    if (controller_.empty())
      throw std::runtime_error(path_ +
                               " is plugged by its gadget: write to that one's file UDC, or name "
                               "it by --udc");
  }
  void open_file() {
    file_ = open(path_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (file_ < 0)
      port_failed(path_,
                  "it needs a gadget with a HID function of 64 bytes each way, and its rights");
  }

  std::string path_, controller_;
  std::string udc_;  // what the controller's file said
  int file_ = -1;
};

}  // namespace

std::unique_ptr<DevicePort> socket_port(const std::string& path) {
  return std::make_unique<SocketPort>(path);
}

std::unique_ptr<DevicePort> gadget_port(const std::string& path, const std::string& controller) {
  return std::make_unique<GadgetPort>(path, controller);
}

}  // namespace trocar::cli
