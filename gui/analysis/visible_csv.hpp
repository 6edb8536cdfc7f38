// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "gui/data/data_store.hpp"

namespace trocar::gui {

/// Signals from `begin` to `end` [s], both included, as a table: "time [s],wall.force.z [N],…", in
/// SI units, each number so that it reads back as the same. Threads have rows at times of their
/// own: a cell is empty where its signal's thread has no row. What the run does not have is left
/// out.
std::string csv_of(const DataStore& data, const std::vector<std::string>& names, double begin,
                   double end);

/// @throw std::runtime_error when no signal is there, or the file cannot be written
void write_csv(const QString& path, const DataStore& data, const std::vector<std::string>& names,
               double begin, double end);

}  // namespace trocar::gui
