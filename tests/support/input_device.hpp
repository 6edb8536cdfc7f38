// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "components/devices/generic_hid.hpp"
#include "components/devices/hid/device_layout.hpp"
#include "components/devices/hid/input_line.hpp"
#include "components/devices/hid/pipe_link.hpp"
#include "framework/component_definition.hpp"
#include "framework/scripting/definition_file.hpp"
#include "tests/support/virtual_time.hpp"

namespace trocar::test {

/// A layout's text as its reader sees it, and all that is wrong with it: "fields.x: message".
struct ReadLayout {
  std::optional<hid::DeviceLayout> layout;
  std::vector<std::string> wrong;
};

inline ReadLayout read_layout_text(const std::string& text) {
  ReadLayout read;
  Findings findings;
  const auto value = lua::read_definition("layout.lua", "layout.lua", text, findings);
  for (const Finding& finding : findings.all()) read.wrong.push_back(finding.text());
  if (!value) return read;
  std::vector<DefinitionMistake> mistakes;
  read.layout = hid::read_device_layout(*value, mistakes);
  for (const DefinitionMistake& mistake : mistakes) {
    std::string path;
    for (const std::string& each : mistake.path) path += (path.empty() ? "" : ".") + each;
    read.wrong.push_back(path + ": " + mistake.message);
  }
  return read;
}

inline std::string shipped_layout(const std::string& name) {
  const ComponentType type = generic_hid_type();
  for (const ComponentDefinition::Shipped& shipped : type.definition->shipped)
    if (shipped.name == name) return shipped.text;
  return "";
}

/// A port into which a test plugs a device of its own.
class TestPort final : public hid::LinkSource {
 public:
  explicit TestPort(std::unique_ptr<hid::PipeLink>& device, const bool& present)
      : device_(device), present_(present) {}
  hid::LinkPair open() override {
    if (!present_) throw std::runtime_error("no HID device is 046d:c626");
    auto [host, device] = hid::PipeLink::make_pair();
    device_ = std::move(device);
    return {std::move(host), nullptr};
  }

 private:
  std::unique_ptr<hid::PipeLink>& device_;
  const bool& present_;
};

/// A GenericHid on such a port, in time of the test's own.
class PortHid final : public GenericHid {
 public:
  explicit PortHid(std::shared_ptr<const hid::DeviceLayout> layout)
      : GenericHid(layout), shared_(std::move(layout)) {}

  void send(const std::vector<std::uint8_t>& bytes) { device->write(bytes); }
  /// One tick later by the port's time.
  void tick(double ms = 1.0) {
    time.now_ns += static_cast<std::int64_t>(ms * 1e6);
    step({});
  }

  VirtualTime time;
  bool present = true;
  std::unique_ptr<hid::PipeLink> device;

 protected:
  std::unique_ptr<hid::InputLine> line() override {
    return std::make_unique<hid::InputLine>(std::make_unique<TestPort>(device, present), time,
                                            *shared_, false);
  }

 private:
  std::shared_ptr<const hid::DeviceLayout> shared_;
};

}  // namespace trocar::test
