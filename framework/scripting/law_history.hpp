// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <span>
#include <vector>

#include "framework/realtime/broadcast_ring.hpp"
#include "framework/scripting/law_state.hpp"
#include "framework/tick.hpp"

namespace trocar::lua {

/// What a law was given in its last steps, for another version of it to be tried on: the tick, its
/// state before the step, its parameters' numbers, and its inputs. Written by the loop, read from
/// outside of it.
class LawHistory {
 public:
  /// Sizes of a record's parts.
  struct Shape {
    std::size_t parameters = 0;         // numbers
    std::vector<std::size_t> inputs{};  // [bytes] of each
  };

  LawHistory(Shape shape, std::size_t steps)
      : shape_(std::move(shape)),
        size_(size_of(shape_)),
        ring_(steps * (size_ + BroadcastRing::head_size), size_) {}

  const Shape& shape() const RT_SAFE { return shape_; }

  /// A record that is being written, part by part: tick, state, parameters, inputs.
  class Writer {
   public:
    explicit Writer(LawHistory& history) RT_SAFE : history_(history),
                                                   to_(history.ring_.begin(history.size_)) {}
    ~Writer() { history_.ring_.commit(0); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    void put(const void* bytes, std::size_t size) RT_SAFE {
      std::memcpy(to_.data(), bytes, size);
      to_ = to_.subspan(padded(size));
    }

   private:
    LawHistory& history_;
    std::span<std::byte> to_;
  };

  /// One of the past, as a copy.
  struct Step {
    Tick tick{};
    LawState::Numbers state{};
    std::vector<double> parameters{};
    std::vector<std::vector<std::byte>> inputs{};
  };
  /// The oldest first.
  std::vector<Step> steps() {
    std::vector<Step> all;
    BroadcastRing::Cursor cursor(ring_, BroadcastRing::Cursor::Start::oldest);
    while (const auto record = cursor.next()) all.push_back(step_of(record->bytes));
    return all;
  }

 private:
  static constexpr std::size_t padded(std::size_t size) RT_SAFE { return (size + 7) / 8 * 8; }
  static std::size_t size_of(const Shape& shape) {
    std::size_t size = sizeof(Tick) + sizeof(LawState::Numbers) + sizeof(double) * shape.parameters;
    for (const std::size_t input : shape.inputs) size += padded(input);
    return size;
  }
  Step step_of(std::span<const std::byte> bytes) const {
    const auto take = [&](void* to, std::size_t size) {
      std::memcpy(to, bytes.data(), size);
      bytes = bytes.subspan(padded(size));
    };
    Step step;
    take(&step.tick, sizeof step.tick);
    take(&step.state, sizeof step.state);
    step.parameters.resize(shape_.parameters);
    for (double& number : step.parameters) take(&number, sizeof number);
    for (const std::size_t size : shape_.inputs) {
      step.inputs.emplace_back(size);
      take(step.inputs.back().data(), size);
    }
    return step;
  }

  Shape shape_;
  std::size_t size_;
  BroadcastRing ring_;
};

}  // namespace trocar::lua
