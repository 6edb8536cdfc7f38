// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/replaceable.hpp"
#include "framework/scripting/lua_law.hpp"

namespace trocar::lua {

/// A version of a law, made ready to take over.
class LawVersion final : public Replacement {
 public:
  LawVersion(std::shared_ptr<const LawFile> file, std::unique_ptr<LuaLaw> law)
      : file_(std::move(file)), law_(std::move(law)) {}

  LuaLaw& law() RT_SAFE { return *law_; }
  const LawFile& file() const { return *file_; }

  std::string trouble() const override { return trouble_; }
  /// In the loop, before release(): it failed, or stepped a force too far.
  void give_up(const char* why) RT_SAFE { trouble_ = why; }

 private:
  std::shared_ptr<const LawFile> file_;  // the law refers to it
  std::unique_ptr<LuaLaw> law_;
  const char* trouble_ = "";  // of the law's own memory, or of the program's
};

/// How far a change of laws may go, and how long it takes.
struct ChangeLimits {
  std::int64_t ramp_steps = 200;
  std::int64_t probation_steps = 1000;
  double force = 2.0;   // [N] that a force's component may differ by at first
  double moment = 0.2;  // [N m]
};

/// Evaluates the law that is in charge. When another one takes over it hands on the state, ramps
/// the outputs from where they were, keeps the former law until the new one has proved itself, and
/// goes back to it when that fails, or differs too much at its first step.
class LawChange {
 public:
  /// @param first stays in charge until something replaces it
  void begin(LawVersion& first, const ChangeLimits& limits);
  /// From the next step on.
  void replace(LawVersion& next) RT_SAFE;
  /// A step of whoever is in charge; its outputs are written.
  /// @return false when it failed, and nothing could take its place
  bool step(const Tick& tick) RT_SAFE;
  LuaLaw& law() RT_SAFE { return now_->law(); }
  const LuaLaw& law() const RT_SAFE { return now_->law(); }
  const LawVersion& version() const { return *now_; }
  bool take_news(Event& news) RT_SAFE;

 private:
  enum class Limit { none, plain, force, moment };  // of an output: none is not ramped
  bool judge(const Tick& tick, bool right) RT_SAFE;
  bool go_back(const Tick& tick) RT_SAFE;
  bool too_far() RT_SAFE;
  void hand_over(const LuaLaw& from, const LuaLaw& to) RT_SAFE;
  void begin_ramp() RT_SAFE;
  void keep_outputs() RT_SAFE;
  void end_probation() RT_SAFE;
  void tell(Event::Kind kind, const char* detail, double value = 0.0, double limit = 0.0) RT_SAFE;

  LawVersion* now_ = nullptr;
  LawVersion* former_ = nullptr;  // until the probation ends
  ChangeLimits limits_;
  std::vector<Limit> kinds_;  // of each number of the outputs
  OutputRamp ramp_;
  std::vector<double> last_;   // outputs as they were written
  LawState::Numbers state_{};  // on its way from one to the other
  std::int64_t probation_left_ = 0;
  bool first_step_ = false;
  bool changed_ = false;  // ever: until then nothing of this costs anything
  std::array<Event, 4> news_{};
  std::size_t untold_ = 0;
};

}  // namespace trocar::lua
