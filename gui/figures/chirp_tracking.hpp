// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gui/figures/result_file.hpp"

namespace trocar::gui {

/// How a tip follows a chirp, from a log's rows, at 1 kHz where there are more.
/// tip(t) = gain reference(t - lag), by least squares, as scripts/experiments/chirp.lua fits it.
struct ChirpTracking {
  std::string axis;               // "z"
  std::vector<double> time;       // [s] of the run
  std::vector<double> reference;  // from where it starts [m]
  std::vector<double> tip;        // likewise [m]
  std::vector<double> error;      // tip less reference [m]
  double rms = 0.0;               // of the error [m]
  double worst = 0.0;             // of the error [m]
  double gain = 0.0;
  double lag = 0.0;  // [s]
};

/// Finds the ChirpMotion whose offset goes to a PoseSpring, in the log's graph.
/// @throw FigureError when the log has none, or not their signals
ChirpTracking chirp_tracking(const ResultFile& file, int run, const std::string& thread);

/// "z: error 0.2326 mm RMS, 0.4926 mm at worst; gain 1.00082, lag 2.258 ms".
std::string tracking_text(const ChirpTracking& chirp);

}  // namespace trocar::gui
