// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"
#include "framework/recording/triggered_log.hpp"

namespace trocar {

/// Says that a piece of the run is written to a log of its own when a signal rises above or falls
/// below a value, from some time before that moment. It does nothing in the loop: the signal is
/// looked at in the rows.
class Capture final : public Component {
 public:
  /// @throw std::invalid_argument when the signal is not one number, or nothing is asked of it, or
  /// that is in another unit
  void configure(const Setup& setup) override;
  void step(const Tick&) RT_SAFE override {}

  GenericInput signal{this, "signal", {.doc = "a single number that is watched"}};
  Parameter<std::string> file{
      this, "file", {.initial = "capture.mcap", .doc = "where the log is written (MCAP)"}};
  Parameter<Quantity> above{
      this, "above", {.initial = "\"inf\"", .doc = "capture when the signal is above this"}};
  Parameter<Quantity> below{
      this, "below", {.initial = "\"-inf\"", .doc = "capture when the signal is below this"}};
  Parameter<Choice> when{
      this,
      "when",
      {.initial = "edge",
       .doc = "edge: as it gets above or below; level: in every row in which it is",
       .choices = {"edge", "level"}}};
  Parameter<double> before{this,
                           "before",
                           {.unit = "s",
                            .initial = "1 s",
                            .min = "0 s",
                            .max = "60 s",
                            .doc = "that the log begins before that moment"}};
  Parameter<double> after{this,
                          "after",
                          {.unit = "s",
                           .initial = "1 s",
                           .min = "0 s",
                           .max = "600 s",
                           .doc = "that the log goes on after it"}};

  bool by_level() const { return when->index == 1; }
};

/// Watches in the rows what a Capture asks for.
class SignalTrigger final : public Trigger {
 public:
  /// @param name of the Capture in the graph
  explicit SignalTrigger(std::string name) : name_(std::move(name)) {}
  Window begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) override;
  bool row(std::size_t group, std::span<const std::byte> row) override;
  /// "wall.load above 2 N at tick 812 (0.812 s): 2.03 N"
  std::string cause() const override;

 private:
  std::string name_;
  std::string signal_;
  std::size_t group_ = 0;  // of the thread whose rows have the signal
  std::size_t row_offset_ = 0;
  Quantity above_, below_;
  bool by_level_ = false;
  bool was_beyond_ = true;  // an edge needs a row before it
  double value_ = 0.0;
  RowHeader header_;
};

}  // namespace trocar
