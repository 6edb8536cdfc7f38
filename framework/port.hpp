// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "framework/connection.hpp"
#include "framework/realtime/rt_safe.hpp"
#include "framework/types.hpp"
#include "framework/units.hpp"

namespace trocar {

class Component;

/// What a port carries: two ports connect when theirs agree.
struct Signature {
  const TypeInfo* type = nullptr;
  int axes = 0;               // of Joints and Jacobian
  std::vector<Unit> units{};  // one for each block of the type
  std::string frame{};        // "" where none applies

  /// "Vector3 [N] in device"
  std::string text() const;
  /// The units alone: "N, N m"; "" where there is none.
  std::string unit_text() const;
};

/// Why a value of `source` cannot be read as `target`, or "" when it can.
std::string mismatch(const Signature& source, const Signature& target);

/// A field of a value: `tool.tip.position.z`.
struct FieldSelection {
  Signature signature;
  std::size_t offset = 0;  // [bytes]
};

/// @throw std::invalid_argument when the path names no field, with those that there are.
FieldSelection select_field(const Signature& whole, std::string_view path);

/// How good a signal is; each component that makes it worse says so when it is configured.
struct SignalQuality {
  double delay = 0.0;                // [s] behind what it stands for
  std::vector<double> resolution{};  // the step that one count makes, for each number; [] exact
};

struct PortOptions {
  std::string_view unit = {};  // "N", or one for each block: "N, N m"; "" takes the type's own
  std::string_view frame = {};
  std::string_view doc = {};
  int axes = 0;                          // of Jacobian; Joints count their units
  bool optional = false;                 // an input that may stay unconnected
  bool feedthrough = true;               // an input that this tick's outputs depend on
  std::vector<std::string> labels = {};  // of an Enumeration
};

/// A declared end of a connection. Ports are members of their component and live as long.
class Port {
 public:
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  const std::string& name() const { return name_; }
  const std::string& doc() const { return doc_; }
  const std::vector<std::string>& labels() const { return labels_; }
  const std::string& owner_name() const;  // of the component
  /// Nothing while a generic port is not wired to anything that has a type.
  const std::optional<Signature>& signature() const { return signature_; }
  bool generic() const { return generic_; }
  void set_signature(const Signature& signature) { signature_ = signature; }

 protected:
  Port(Component* owner, std::string_view name, const TypeInfo* type, const PortOptions& options);
  ~Port() = default;

 private:
  // A component must not get from its inputs to those that feed it.
  friend class Wiring;
  const Component& owner() const { return *owner_; }

  Component* owner_;
  std::string name_;
  std::string doc_;
  std::vector<std::string> labels_;
  std::optional<Signature> signature_;
  bool generic_;
};

class OutputPort : public Port {
 public:
  /// Only a simulation can know it: it is named "truth.position" or the like.
  bool truth() const { return name().starts_with("truth."); }
  SignalQuality quality{};

  /// Gives the output its place in the graph's memory, filled with its initial value.
  virtual void place(std::byte* memory) = 0;
  const std::byte* data() const { return data_; }

 protected:
  OutputPort(Component* owner, std::string_view name, const TypeInfo* type,
             const PortOptions& options);
  ~OutputPort() = default;
  std::byte* data_ = nullptr;
};

/// Where an input reads: an output, and how far into its value.
struct Source {
  const OutputPort* output = nullptr;
  std::size_t offset = 0;  // [bytes]
  bool this_tick = true;   // the output is written before it is read; else it is a tick old
  const SampleInfo* info = nullptr;  // of a value from another thread
  const std::byte* value = nullptr;  // where that is copied to
  double transfer = 0.0;             // [s] that it may be older for that
};

class InputPort : public Port {
 public:
  bool optional() const { return optional_; }
  bool feedthrough() const { return feedthrough_; }
  /// Takes any number of sources, in the order in which they were wired.
  bool variadic() const { return variadic_; }
  const std::vector<Source>& sources() const { return sources_; }
  bool connected() const { return !sources_.empty(); }

  /// Called once the outputs have their places.
  void connect(const Source& source);

  /// What is known of the value that is read: of one from the same thread, that it is valid.
  const SampleInfo& sample(std::size_t source = 0) const RT_SAFE;

  /// [s] behind what the signal stands for.
  double delay() const;
  /// The step that one count makes in the i-th number of a source; 0 for an exact signal.
  double resolution(std::size_t i = 0, std::size_t source = 0) const;

 protected:
  InputPort(Component* owner, std::string_view name, const TypeInfo* type,
            const PortOptions& options, bool variadic);
  ~InputPort() = default;
  virtual void attach(const std::byte* value) = 0;

 private:
  bool optional_;
  bool feedthrough_;
  bool variadic_;
  std::vector<Source> sources_;
};

/// An output of type T. Until a graph places it, it writes to itself, so that a component can be
/// tested alone.
template <PortValue T>
class Output final : public OutputPort {
 public:
  Output(Component* owner, std::string_view name, const PortOptions& options)
      : OutputPort(owner, name, &type_info<T>(), options) {
    data_ = reinterpret_cast<std::byte*>(&own_);
  }
  T& operator*() RT_SAFE { return *value_; }
  T* operator->() RT_SAFE { return value_; }
  const T& operator*() const RT_SAFE { return *value_; }
  const T* operator->() const RT_SAFE { return value_; }

  void place(std::byte* memory) override {
    value_ = new (memory) T(*value_);
    data_ = memory;
  }

 private:
  T own_{};
  T* value_ = &own_;
};

/// An input of type T: a pointer to the producer's value. Unconnected, it reads `initial`.
template <PortValue T>
class Input final : public InputPort {
 public:
  Input(Component* owner, std::string_view name, const PortOptions& options, const T& initial = {})
      : InputPort(owner, name, &type_info<T>(), options, false), initial_(initial) {}
  const T& operator*() const RT_SAFE { return *value_; }
  const T* operator->() const RT_SAFE { return value_; }

 private:
  void attach(const std::byte* value) override { value_ = reinterpret_cast<const T*>(value); }
  T initial_;
  const T* value_ = &initial_;
};

/// An input that takes any number of sources of type T.
template <PortValue T>
class Inputs final : public InputPort {
 public:
  Inputs(Component* owner, std::string_view name, const PortOptions& options)
      : InputPort(owner, name, &type_info<T>(), options, true) {}
  auto begin() const RT_SAFE { return values_.begin(); }  // of const T*
  auto end() const RT_SAFE { return values_.end(); }

 private:
  void attach(const std::byte* value) override {
    values_.push_back(reinterpret_cast<const T*>(value));
  }
  std::vector<const T*> values_;
};

/// Sum of forces that act at one place, in the order in which they were wired.
Eigen::Vector3d sum(const Inputs<Vector3>& vectors) RT_SAFE;

/// An output whose type, unit and frame come from what it is wired to; numbers only.
class GenericOutput final : public OutputPort {
 public:
  GenericOutput(Component* owner, std::string_view name, const PortOptions& options)
      : OutputPort(owner, name, nullptr, options) {}
  std::span<double> values() const RT_SAFE { return values_; }
  void place(std::byte* memory) override;

 private:
  std::span<double> values_;
};

/// An input, or several, of a type that comes from the wiring.
class GenericInput final : public InputPort {
 public:
  GenericInput(Component* owner, std::string_view name, const PortOptions& options,
               bool variadic = false)
      : InputPort(owner, name, nullptr, options, variadic) {}
  const double* values(std::size_t source = 0) const RT_SAFE { return values_[source]; }
  std::size_t count() const RT_SAFE { return values_.size(); }

 private:
  void attach(const std::byte* value) override {
    values_.push_back(reinterpret_cast<const double*>(value));
  }
  std::vector<const double*> values_;
};

}  // namespace trocar
