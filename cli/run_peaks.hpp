// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/recording/row_sink.hpp"

namespace trocar::cli {

/// The farthest that something got in a run, and when.
struct RunPeak {
  std::string name;  // "wall.force", "laparoscope.device.effort_sent.axis1"
  std::string unit;  // SI
  double value = 0.0;
  double time = 0.0;              // [s]
  std::optional<double> limit{};  // of the device
};

/// Looks for the peaks of a run: forces that are put at sites and velocities there (norms), efforts
/// of devices beside their limits, and the memory of laws. A number that is not finite is no peak.
class RunPeaks final : public RowSink {
 public:
  std::string_view reader_name() const override { return "peaks"; }
  void begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) override;
  void row(std::size_t group, std::span<const std::byte> row) override;

  std::vector<RunPeak> motion() const { return of(false); }
  /// `script.allocations` and `script.memory` of each law.
  std::vector<RunPeak> laws() const { return of(true); }

 private:
  struct Tracked {
    RunPeak peak;
    std::size_t group = 0;
    std::vector<RowSignal> numbers{};  // whose norm it is
    bool law = false;
  };
  std::vector<RunPeak> of(bool law) const;
  void add(const std::vector<RowLayout>& layouts, const OutputPort& output, std::size_t offset,
           std::size_t count, bool one_by_one, const double* limits);
  void add_laws(const std::vector<RowLayout>& layouts);

  std::vector<Tracked> tracked_;
};

}  // namespace trocar::cli
