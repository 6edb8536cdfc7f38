// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gui/data/data_store.hpp"
#include "gui/operate/named_signals.hpp"

namespace trocar::gui {

/// Whether the newest rows say that a force is rendered: a gate lets effort pass, the device says
/// of itself that it is engaged, or its amplifiers make more than what holds its weight.
///
///   |applied_i - hold_i| > tolerance_i  and  |applied_i| > tolerance_i,
///   tolerance 6 N for forces, 0.4 N m for moments
///
/// After a stop the gate's damping stays, of at most 5 N and 0.3 N m (docs/safety.md).
bool renders(const DataStore& data, const NamedSignals& signals);

}  // namespace trocar::gui
