// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "framework/recording/row_sink.hpp"

namespace trocar {

/// A vector that people want to hear of after a run: a force at a site, or where the site was.
struct Highlight {
  std::string name;  // "wall.force", "laparoscope.tool.tip.position"
  std::string unit;  // SI
  bool is_force = false;
  std::size_t group = 0;  // of which thread
  std::size_t row_offset = 0;
  double peak = 0.0;       // largest norm
  double peak_time = 0.0;  // [s]
  Vector3 at_peak{};
  Vector3 last{};
};

/// What a run looked like from the hand: peaks and ends of the forces at sites, and about a dozen
/// moments spread over the run.
class Highlights final : public RowSink {
 public:
  struct Moment {
    double time = 0.0;  // [s]
    std::vector<Vector3> values{};
  };

  std::string_view reader_name() const override { return "highlights"; }
  void begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) override;
  void row(std::size_t group, std::span<const std::byte> row) override;

  const std::vector<Highlight>& all() const { return all_; }
  /// Evenly spaced, the last row being the last of them.
  std::vector<Moment> moments() const;

 private:
  static constexpr std::size_t most_moments = 24;
  using Place = std::pair<std::size_t, std::size_t>;      // of a value: group, offset in its row
  using Places = std::multimap<std::string_view, Place>;  // by the port's name
  static Places places_in(const std::vector<RowLayout>& layouts);
  void add(const Places& places, const OutputPort& output, std::size_t offset, bool is_force);

  std::vector<Highlight> all_;
  std::set<Place> known_;
  std::vector<Moment> moments_;
  Moment latest_;
  std::size_t stride_ = 1;
  std::size_t count_ = 0;
};

}  // namespace trocar
