// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

namespace trocar::gui {

/// A number in SI as people read it, with its unit: 0.0123 [m] is "12.30 mm". What is not a number
/// is "–", never 0.
QString shown_number(double value, const std::string& unit);

/// The same without the unit, which is `shown_unit(unit)`.
QString shown_value(double value, const std::string& unit);
QString shown_unit(const std::string& unit);
double shown_scale(const std::string& unit);  // what is shown for one in SI

/// "1.23 µs", "4.5 ms": [ns]
QString shown_duration(double nanoseconds);

}  // namespace trocar::gui
