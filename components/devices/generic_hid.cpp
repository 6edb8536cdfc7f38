// SPDX-License-Identifier: Apache-2.0
#include "components/devices/generic_hid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "components/devices/hid/input_line.hpp"
#include "components/devices/hid/link_sources.hpp"
#include "components/devices/hid/shipped_layouts.hpp"

namespace trocar {
namespace {

enum class InputStatus : std::int64_t { absent, quiet, sending };  // as the labels

std::string given(const Parameter<std::string>& parameter) {
  return *parameter == "any" ? std::string() : *parameter;
}

bool is_empty(const Literal& list) {
  const auto* entries = list.as<Literal::List>();
  return entries != nullptr && entries->empty();
}

/// Names that the outputs of a layout cannot have.
void refuse_own_names(const hid::DeviceLayout& layout, std::vector<DefinitionMistake>& mistakes) {
  const GenericHid bare(std::make_shared<hid::DeviceLayout>());
  for (const hid::LayoutOutput& output : layout.outputs)
    if (bare.find_output(output.name) != nullptr || bare.find_parameter(output.name) != nullptr ||
        output.name == "layout" || output.name == "name")
      mistakes.push_back({{"fields", output.name},
                          "is the name of something that each GenericHid has: take another"});
}

ComponentDefinition::Make read_layout(const Literal& value,
                                      std::vector<DefinitionMistake>& mistakes) {
  auto layout = hid::read_device_layout(value, mistakes);
  if (layout) refuse_own_names(*layout, mistakes);
  if (!mistakes.empty()) return {};
  return [shared = std::make_shared<const hid::DeviceLayout>(std::move(*layout))] {
    return std::make_unique<GenericHid>(shared);
  };
}

}  // namespace

GenericHid::GenericHid(std::shared_ptr<const hid::DeviceLayout> layout)
    : layout_(std::move(layout)) {
  using Kind = hid::LayoutOutput::Kind;
  for (const hid::LayoutOutput& output : layout_->outputs) {
    const PortOptions options{.unit = output.unit, .frame = output.frame, .doc = output.doc};
    if (output.kind == Kind::flag) flags_.emplace_back(this, output.name, options);
    if (output.kind == Kind::number) numbers_.emplace_back(this, output.name, options);
    if (output.kind == Kind::vector) vectors_.emplace_back(this, output.name, options);
  }
  snapshot_.begin(*layout_);
}

GenericHid::~GenericHid() = default;

void GenericHid::configure(const Setup& setup) {
  virtual_time_ = setup.virtual_time;
  stale_ns_ = std::llround(*stale * 1e9);
  played_.reset();
  if (!is_empty(*play)) played_.emplace(*play);
}

std::unique_ptr<hid::InputLine> GenericHid::line() {
  static MonotonicTime time;  // has no state
  hid::DeviceSelection selection = layout_->device;
  selection.serial = given(serial);
  selection.path = given(path);
  return std::make_unique<hid::InputLine>(hid::source_of(selection), time, *layout_);
}

void GenericHid::start() {
  snapshot_.begin(*layout_);
  if (played_)
    played_->begin(snapshot_);
  else if (!virtual_time_)
    open();
  write(0);
}

void GenericHid::open() {
  line_ = line();
  try {
    line_->open();
  } catch (const std::exception& error) {
    if (*needed) throw std::runtime_error(name() + ": " + error.what());
  }
  line_->start(name());
  line_->load(snapshot_);
}

void GenericHid::step(const Tick& tick) RT_SAFE {
  if (played_) played_->play(tick.time_ns, layout_->fields, snapshot_);
  if (line_) line_->load(snapshot_);
  write(line_ ? line_->now() : tick.time_ns);
}

void GenericHid::stop() {
  line_.reset();
}

void GenericHid::write(std::int64_t now_ns) RT_SAFE {
  using Kind = hid::LayoutOutput::Kind;
  auto number = numbers_.begin();
  auto flag = flags_.begin();
  auto vector = vectors_.begin();
  for (const hid::LayoutOutput& output : layout_->outputs) {
    const double* value = snapshot_.valid(output, now_ns, stale_ns_)
                              ? snapshot_.value.data() + output.first
                              : output.rest;
    if (output.kind == Kind::flag) **flag++ = *value != 0.0;
    if (output.kind == Kind::number) **number++ = *value;
    if (output.kind == Kind::vector) **vector++ = Vector3(value[0], value[1], value[2]);
  }
  const bool heard =
      snapshot_.heard_ns != hid::InputSnapshot::never && now_ns - snapshot_.heard_ns <= stale_ns_;
  status->index = static_cast<std::int64_t>(!snapshot_.attached ? InputStatus::absent
                                            : heard             ? InputStatus::sending
                                                                : InputStatus::quiet);
  *reports = snapshot_.reports;
  *reports_ignored = snapshot_.ignored;
  *connections = snapshot_.connections;
}

ComponentType generic_hid_type() {
  ComponentDefinition layout{
      .entry = "layout",
      .doc =
          "of the device's reports: a table, a file in Lua that returns one, or the name of a "
          "shipped one; it declares further outputs",
      .example = "\"space_navigator\"",
      .shipped = hid::shipped_layouts(),
      .read = read_layout};
  return {
      .name = "GenericHid",
      .category = "devices",
      .doc = "Any HID device that a layout describes, as an input",
      .make = [] { return std::make_unique<GenericHid>(std::make_shared<hid::DeviceLayout>()); },
      .make_group = {},
      .definition = std::make_shared<const ComponentDefinition>(std::move(layout))};
}

}  // namespace trocar
