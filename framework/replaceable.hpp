// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "framework/event.hpp"
#include "framework/realtime/stop_flag.hpp"

namespace trocar {

/// Something that was made ready outside of the loop, to take the place of a part of a component
/// that runs. Whoever made it keeps it until the loop has released it, or has ended.
class Replacement {
 public:
  Replacement() = default;
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  virtual ~Replacement() = default;

  /// The loop will not touch it again.
  void release() RT_SAFE { released_.raise(); }
  bool released() const { return released_.raised(); }
  /// Why the loop gave it up, once it is released; "" when it served.
  virtual std::string trouble() const { return ""; }

 private:
  StopFlag released_;
};

/// A new version of a component's part, at a time of a run.
struct Reload {
  double at = 0.0;          // [s]
  std::string component{};  // "membrane"
  std::string file{};       // as it was asked for
  std::string path{};       // where that is
  std::string text{};
};

/// A component of which a part can be exchanged while it runs: the law of a LuaFixture.
class Replaceable {
 public:
  virtual ~Replaceable() = default;

  /// The file that it comes from.
  virtual const std::string& source() const = 0;
  /// Makes a new version ready and tries it on what the component has seen of late. In real time
  /// from one thread outside of the loop; in virtual time between two steps.
  /// @throw std::invalid_argument with the reason when it cannot take over
  virtual std::unique_ptr<Replacement> prepare(const Reload& reload) = 0;

  // In the loop, between two steps:
  /// From the next step on.
  virtual void replace(Replacement& next) RT_SAFE = 0;
  /// What has become of replacements since the last call: kind, detail, value and limit are set.
  /// @return false when there is nothing to tell
  virtual bool take_news(Event& news) RT_SAFE = 0;
};

/// What came of it.
struct ReloadVerdict {
  std::string component;
  std::string file;
  std::string code;     // the file's text
  double time = 0.0;    // [s]
  std::string trouble;  // why it was refused, or given up; "" when it took over

  std::string text() const;
};

}  // namespace trocar
