// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "components/devices/hid/link.hpp"

namespace trocar::hid {

/// Reports through a socket of SOCK_SEQPACKET, each a packet: to an emulated device in the same
/// process or in another one. What the other side does not take is lost, as on USB.
class PipeLink final : public Link {
 public:
  /// Two ends of a new pipe. @throw std::system_error
  static std::pair<std::unique_ptr<PipeLink>, std::unique_ptr<PipeLink>> make_pair();
  /// To who listens at a socket in the file system.
  /// @throw std::runtime_error with the path and the cure
  static std::unique_ptr<PipeLink> connect(const std::string& path);

  /// @param file an open socket, which it closes in the end
  explicit PipeLink(int file) : file_(file) {}
  ~PipeLink() override;
  PipeLink(const PipeLink&) = delete;
  PipeLink& operator=(const PipeLink&) = delete;

  int read(std::span<std::uint8_t> into, int timeout_ms) override;
  bool write(ReportBytes report) override;
  /// The same end once more, for another thread. @throw std::system_error
  std::unique_ptr<PipeLink> second() const;

 private:
  int file_;
};

/// A socket in the file system as a source of links.
class SocketSource final : public LinkSource {
 public:
  explicit SocketSource(std::string path) : path_(std::move(path)) {}
  LinkPair open() override;

 private:
  std::string path_;
};

}  // namespace trocar::hid
