// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "framework/recording/row_sink.hpp"

namespace trocar::cli {

/// One line on the terminal, rewritten some times a second, that shows how a run goes: time, force,
/// lateness, faults.
class Progress final : public RowSink {
 public:
  std::string_view reader_name() const override { return "progress"; }
  bool needs_every_row() const override { return false; }
  void begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) override;
  void row(std::size_t group, std::span<const std::byte> row) override;
  void event(std::size_t group, const Event& event) override;
  void end() override;

 private:
  void show(double time);

  struct Force {  // at a site
    std::size_t group = 0;
    std::size_t row_offset = 0;
    double now = 0.0;  // [N]
  };
  std::vector<Force> forces_;
  std::int64_t next_ns_ = 0;  // on the wall's clock
  std::int64_t worst_lateness_ = 0;
  int faults_ = 0;
  int rows_since_look_ = 0;
  bool shown_ = false;
};

}  // namespace trocar::cli
