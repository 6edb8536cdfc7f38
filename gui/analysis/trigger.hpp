// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "gui/analysis/time_view.hpp"
#include "gui/data/data_store.hpp"

namespace trocar::gui {

/// When a picture is taken, as on an oscilloscope.
struct TriggerSettings {
  enum class When { rises, falls, crosses, above, below };
  enum class Mode { automatic, normal, single };

  std::string signal{};
  When when = When::rises;
  Mode mode = Mode::normal;
  double level = 0.0;       // in the signal's unit
  double hysteresis = 0.0;  // the signal must have been so far on the other side before
  double before = 0.5;      // [s] shown before the trigger
  double after = 0.5;       // [s] and after it

  bool operator==(const TriggerSettings&) const = default;
};

inline constexpr std::array trigger_whens = {"rises", "falls", "crosses", "above", "below"};
inline constexpr std::array trigger_modes = {"auto", "normal", "single"};

/// Looks for the trigger in every row, so that what lasted one tick triggers too.
/// Edges: the signal reaches `level` after it was beyond it by more than the hysteresis. Levels
/// ("above", "below"): it is there. A shot is ready when all of the time after it is there; the
/// next is looked for behind that. Normal holds a shot until the next, single holds the first, and
/// automatic lets the picture run again when none has come for a while.
class Trigger {
 public:
  enum class State { off, armed, filling, held };

  /// Looks for `settings` in what comes from now on.
  void arm(const DataStore& data, const TriggerSettings& settings);
  void disarm();
  /// Looks at what has come. @return whether there is another shot, or none any more
  bool search(const DataStore& data);

  State state() const { return state_; }
  const TriggerSettings& settings() const { return settings_; }
  const std::optional<Shot>& shot() const { return shot_; }  // that is complete
  std::uint64_t count() const { return count_; }             // of shots since it was armed

 private:
  bool look(const SignalRef& signal, std::uint64_t end);
  bool fires(double value);
  void begin_at(const SignalRef& signal);
  double patience() const;

  TriggerSettings settings_;
  State state_ = State::off;
  std::optional<Shot> shot_;
  std::uint64_t count_ = 0;
  const Track* track_ = nullptr;
  std::uint64_t next_ = 0;  // row to look at
  bool was_below_ = false, was_above_ = false;
  double found_ = 0.0;  // [s] of the trigger whose time is being filled
};

}  // namespace trocar::gui
