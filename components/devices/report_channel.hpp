// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "components/devices/seeded_random.hpp"

namespace trocar {

/// How a device's reports get to the host.
struct ReportSettings {
  double jitter = 0.0;    // [periods] by which a sample may be taken before its tick, 0–1
  double loss = 0.0;      // share of the reports that never arrive, 0 to below 1
  double loss_run = 1.0;  // mean number of reports lost in a row, at least 1
};

/// Draws, for each period, when the encoders are sampled and whether the report is lost. Jitter is
/// even in [0, jitter); losses are those of the Gilbert channel (Gilbert 1960), a chain of two
/// states of which one loses all:
///
///   P(lost | lost) = 1 - 1 / run       P(lost | arrived) = loss / (run (1 - loss))
///
/// Two draws for each period, whatever comes of them.
class ReportChannel {
 public:
  struct Report {
    double early = 0.0;  // [periods] before the tick
    bool arrives = true;
  };

  ReportChannel(const ReportSettings& settings, std::uint64_t seed)
      : random_(seed),
        jitter_(settings.jitter),
        stays_lost_(1.0 - 1.0 / settings.loss_run),
        gets_lost_(settings.loss / (settings.loss_run * (1.0 - settings.loss))) {}

  Report next() RT_SAFE {
    const double early = random_.uniform(0.0, jitter_);
    lost_ = random_.uniform(0.0, 1.0) < (lost_ ? stays_lost_ : gets_lost_);
    return {early, !lost_};
  }

 private:
  SeededRandom random_;
  double jitter_, stays_lost_, gets_lost_;
  bool lost_ = false;
};

}  // namespace trocar
