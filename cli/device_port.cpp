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
#include <stdexcept>

#include "components/devices/hid/pipe_link.hpp"

namespace trocar::cli {
namespace {

[[noreturn]] void port_failed(const std::string& path, const char* cure) {
  throw std::runtime_error(
      fmt::format("{} cannot be used ({}): {}", path, std::strerror(errno), cure));
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
  explicit GadgetPort(const std::string& path)
      : path_(path), file_(open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC)) {
    if (file_ < 0)
      port_failed(path,
                  "it needs a gadget with a HID function of 64 bytes each way, and its rights");
  }
  ~GadgetPort() override { close(file_); }
  GadgetPort(const GadgetPort&) = delete;
  GadgetPort& operator=(const GadgetPort&) = delete;

  std::size_t receive(std::span<std::uint8_t> into) override {
    const ssize_t size = read(file_, into.data(), into.size());
    return size > 0 ? static_cast<std::size_t>(size) : 0;
  }
  void send(const hid::Report& report) override {
    [[maybe_unused]] const ssize_t sent = write(file_, report.data(), report.size());
  }
  void plug() override { refuse(); }
  void unplug() override { refuse(); }

 private:
  [[noreturn]] void refuse() const {
    throw std::runtime_error(path_ + " is plugged by its gadget: write to that one's file UDC");
  }
  std::string path_;
  int file_;
};

}  // namespace

std::unique_ptr<DevicePort> socket_port(const std::string& path) {
  return std::make_unique<SocketPort>(path);
}

std::unique_ptr<DevicePort> gadget_port(const std::string& path) {
  return std::make_unique<GadgetPort>(path);
}

}  // namespace trocar::cli
