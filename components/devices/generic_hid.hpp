// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>

#include "components/devices/hid/played_reports.hpp"
#include "framework/component.hpp"

namespace trocar {

namespace hid {
class InputLine;
}  // namespace hid

/// Any HID device that a layout describes, as an input: a mouse of six axes, a gamepad.
///
///   output = scale (raw - centre), by the newest report        [unit of the field]
///
/// An output is at rest before its first report, once that is older than `stale`, and while the
/// device is not there; a field that is `held` says otherwise. The device may be missing, and may
/// be unplugged and come back: that is no fault, `status` says so.
///
/// In real time a thread of its own reads the device. In virtual time, and where reports are
/// played, none is opened.
class GenericHid : public Component {
 public:
  explicit GenericHid(std::shared_ptr<const hid::DeviceLayout> layout);
  ~GenericHid() override;
  /// @throw std::invalid_argument for reports to play that are none
  void configure(const Setup& setup) override;
  /// @throw std::runtime_error when the device is needed and not there, or may not be opened
  void start() override;
  void step(const Tick& tick) RT_SAFE override;
  void stop() override;

  Parameter<std::string> serial{
      this, "serial", {.initial = "any", .doc = "of USB, where several are attached"}};
  Parameter<std::string> path{
      this,
      "path",
      {.initial = "any", .doc = "\"/dev/hidraw3\", or a socket with its reports; decides alone"}};
  Parameter<bool> needed{
      this, "needed", {.initial = "false", .doc = "the run is refused while it is not attached"}};
  Parameter<double> stale{this,
                          "stale",
                          {.unit = "s",
                           .initial = "100 ms",
                           .min = "1 ms",
                           .max = "1e5 ms",
                           .doc = "that a report may be old before its fields are at rest"}};
  Parameter<Literal> play{
      this,
      "play",
      {.initial = "{}",
       .doc = "reports in place of a device: { { at = \"0 s\", bytes = \"01 5e 01\" }, … }"}};

  Output<Enumeration> status{
      this,
      "status",
      {.doc = "whether the device is there, and sends", .labels = {"absent", "quiet", "sending"}}};
  Output<std::int64_t> reports{this, "reports", {.doc = "taken, in all"}};
  Output<std::int64_t> reports_ignored{
      this, "reports_ignored", {.doc = "of no field, or too short, in all"}};
  Output<std::int64_t> connections{
      this, "connections", {.doc = "how often the device was found, in all"}};

 protected:
  /// What it gets its reports from; a test has another one.
  virtual std::unique_ptr<hid::InputLine> line();

 private:
  void open();
  void write(std::int64_t now_ns) RT_SAFE;

  std::shared_ptr<const hid::DeviceLayout> layout_;
  std::deque<Output<double>> numbers_;  // each in the order of the layout's outputs
  std::deque<Output<bool>> flags_;
  std::deque<Output<Vector3>> vectors_;
  std::optional<hid::PlayedReports> played_;
  std::unique_ptr<hid::InputLine> line_;
  hid::InputSnapshot snapshot_;
  std::int64_t stale_ns_ = 100'000'000;
  bool virtual_time_ = false;
};

/// GenericHid with its layouts, as a registry takes it.
ComponentType generic_hid_type();

}  // namespace trocar
