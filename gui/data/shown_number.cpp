// SPDX-License-Identifier: Apache-2.0
#include "gui/data/shown_number.hpp"

#include <cmath>
#include <numbers>

namespace trocar::gui {
namespace {

struct ShownAs {
  const char* si;
  const char* unit;
  double scale;  // shown for one in SI
  int decimals;
};

constexpr double degrees_of_a_radian = 180.0 / std::numbers::pi;

constexpr ShownAs shown_as[] = {{"m", "mm", 1e3, 2},
                                {"m/s", "mm/s", 1e3, 1},
                                {"rad", "°", degrees_of_a_radian, 2},
                                {"rad/s", "°/s", degrees_of_a_radian, 1},
                                {"N", "N", 1.0, 2},
                                {"N m", "N m", 1.0, 3},
                                {"s", "ms", 1e3, 3}};

const ShownAs* find_shown(const std::string& unit) {
  for (const ShownAs& one : shown_as)
    if (unit == one.si) return &one;
  return nullptr;
}

}  // namespace

QString shown_unit(const std::string& unit) {
  const ShownAs* as = find_shown(unit);
  if (as != nullptr) return QString::fromUtf8(as->unit);
  return unit == "1" ? QString() : QString::fromStdString(unit);
}

double shown_scale(const std::string& unit) {
  const ShownAs* as = find_shown(unit);
  return as == nullptr ? 1.0 : as->scale;
}

QString shown_value(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "–";
  const ShownAs* as = find_shown(unit);
  if (as == nullptr) return QString::number(value, 'g', 5);
  const QString text = QString::number(as->scale * value, 'f', as->decimals);
  // "-0.00" would look like a direction.
  return text.startsWith('-') && text.toDouble() == 0.0 ? text.mid(1) : text;
}

QString shown_number(double value, const std::string& unit) {
  const QString text = shown_value(value, unit), symbol = shown_unit(unit);
  return std::isfinite(value) && !symbol.isEmpty() ? text + " " + symbol : text;
}

QString shown_duration(double nanoseconds) {
  if (!std::isfinite(nanoseconds)) return "–";
  const double size = std::abs(nanoseconds);
  if (size < 1e3) return QString("%1 ns").arg(nanoseconds, 0, 'f', 0);
  if (size < 1e6) return QString("%1 µs").arg(1e-3 * nanoseconds, 0, 'f', size < 1e5 ? 1 : 0);
  return QString("%1 ms").arg(1e-6 * nanoseconds, 0, 'f', 2);
}

}  // namespace trocar::gui
