// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/pipe_link.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace trocar::hid {
namespace {

std::system_error last_error(const char* what) {
  return {errno, std::generic_category(), what};
}

}  // namespace

std::pair<std::unique_ptr<PipeLink>, std::unique_ptr<PipeLink>> PipeLink::make_pair() {
  int files[2] = {};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, files) != 0)
    throw last_error("no pipe can be made");
  return {std::make_unique<PipeLink>(files[0]), std::make_unique<PipeLink>(files[1])};
}

std::unique_ptr<PipeLink> PipeLink::connect(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path)
    throw std::runtime_error("the socket's path has " + std::to_string(path.size()) +
                             " characters: at most " + std::to_string(sizeof address.sun_path - 1) +
                             " are possible");
  std::memcpy(address.sun_path, path.c_str(), path.size());
  const int file = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  if (file < 0) throw last_error("no socket can be made");
  auto link = std::make_unique<PipeLink>(file);
  if (::connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    throw std::runtime_error("nobody listens at " + path + " (" + std::strerror(errno) +
                             "): start an emulated device there, or name a device by its serial");
  return link;
}

PipeLink::~PipeLink() {
  close(file_);
}

int PipeLink::read(std::span<std::uint8_t> into, int timeout_ms) {
  pollfd input{.fd = file_, .events = POLLIN, .revents = 0};
  const int ready = poll(&input, 1, timeout_ms);
  if (ready == 0 || (ready < 0 && errno == EINTR)) return 0;
  if (ready < 0) return gone;
  const ssize_t size = recv(file_, into.data(), into.size(), MSG_DONTWAIT);
  if (size > 0) return static_cast<int>(size);
  return size < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : gone;
}

bool PipeLink::write(ReportBytes report) {
  const ssize_t sent = send(file_, report.data(), report.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  return sent >= 0 || errno == EAGAIN || errno == EINTR;
}

std::unique_ptr<PipeLink> PipeLink::second() const {
  const int file = dup(file_);
  if (file < 0) throw last_error("the pipe's end cannot be had twice");
  return std::make_unique<PipeLink>(file);
}

LinkPair SocketSource::open() {
  std::unique_ptr<PipeLink> in = PipeLink::connect(path_);
  std::unique_ptr<PipeLink> out = in->second();
  return {std::move(in), std::move(out)};
}

}  // namespace trocar::hid
