// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <vector>

#include "framework/port.hpp"

namespace trocar::lua {

/// A value of a type that is known when the graph is built: numbers 0, rotations none.
class AnyValue {
 public:
  explicit AnyValue(const TypeInfo& type)
      : memory_((type.size + sizeof(double) - 1) / sizeof(double)) {
    rest(type, bytes());
  }
  std::byte* bytes() { return reinterpret_cast<std::byte*>(memory_.data()); }
  const std::byte* bytes() const { return reinterpret_cast<const std::byte*>(memory_.data()); }

 private:
  static void rest(const TypeInfo& type, std::byte* at) {
    if (&type == &type_info<Rotation>()) new (at) Rotation;
    if (&type == &type_info<Rotation>()) return;
    for (const TypeField& field : type.fields) rest(*field.type, at + field.offset);
  }
  std::vector<double> memory_;
};

/// An input whose type a law's file says. Unconnected, it reads 0.
class AnyInput final : public InputPort {
 public:
  AnyInput(Component* owner, std::string_view name, const TypeInfo& type,
           const PortOptions& options)
      : InputPort(owner, name, &type, options, false), initial_(type), value_(initial_.bytes()) {}
  const std::byte* value() const { return value_; }
  /// What it reads while nothing is connected.
  std::byte* own() { return initial_.bytes(); }

 private:
  void attach(const std::byte* value) override { value_ = value; }
  AnyValue initial_;
  const std::byte* value_;
};

/// An output whose type a law's file says.
class AnyOutput final : public OutputPort {
 public:
  AnyOutput(Component* owner, std::string_view name, const TypeInfo& type,
            const PortOptions& options)
      : OutputPort(owner, name, &type, options), size_(type.size), own_(type) {
    data_ = own_.bytes();
  }
  std::byte* value() { return data_; }
  void place(std::byte* memory) override {
    std::memcpy(memory, data_, size_);
    data_ = memory;
  }

 private:
  std::size_t size_;
  AnyValue own_;
};

}  // namespace trocar::lua
