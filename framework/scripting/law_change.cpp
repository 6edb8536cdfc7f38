// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/law_change.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trocar::lua {

void LawChange::begin(LawVersion& first, const ChangeLimits& limits) {
  now_ = &first;
  const LawFile& file = first.file();
  limits_ = limits;
  for (const LawNumber& number : now_->law().output_numbers()) {
    const std::string& port = file.outputs[number.port].name;
    Limit kind = file.kind == LawKind::component ? Limit::plain : Limit::none;
    if (file.kind == LawKind::fixture && port == "force") kind = Limit::force;
    if (file.kind == LawKind::fixture && port == "moment") kind = Limit::moment;
    kinds_.push_back(number.kind == LawNumber::Kind::real ? kind : Limit::none);
  }
  ramp_.resize(kinds_.size());
  last_.assign(kinds_.size(), 0.0);
}

void LawChange::replace(LawVersion& next) RT_SAFE {
  end_probation();
  hand_over(now_->law(), next.law());
  if (!changed_)
    for (std::size_t i = 0; i < last_.size(); ++i) last_[i] = now_->law().found(i);
  changed_ = first_step_ = true;
  former_ = now_;
  now_ = &next;
  probation_left_ = limits_.probation_steps;
}

void LawChange::hand_over(const LuaLaw& from, const LuaLaw& to) RT_SAFE {
  from.kept().read(state_);
  to.kept().write(state_);
}

bool LawChange::step(const Tick& tick) RT_SAFE {
  bool right = now_->law().evaluate(tick);
  if (!changed_) [[likely]] {
    if (right) now_->law().commit();
    return right;
  }
  if (former_ != nullptr) right = judge(tick, right);
  if (!right) return false;
  now_->law().commit(ramp_);
  keep_outputs();
  ramp_.advance();
  return true;
}

bool LawChange::judge(const Tick& tick, bool right) RT_SAFE {
  if (!right) {
    tell(Event::Kind::reload_undone, "it failed");
    now_->give_up(now_->law().error());
    return go_back(tick);
  }
  if (std::exchange(first_step_, false)) {
    if (too_far()) {
      now_->give_up(
          "its force differs too much from the one that is rendered: nearer to where "
          "the two agree it can take over, or \"reload_limit\" may be raised");
      return go_back(tick);
    }
    begin_ramp();
    tell(Event::Kind::reloaded, "");
  }
  if (--probation_left_ == 0) end_probation();
  return true;
}

bool LawChange::go_back(const Tick& tick) RT_SAFE {
  hand_over(now_->law(), former_->law());
  LawVersion& failed = *now_;
  now_ = std::exchange(former_, nullptr);
  first_step_ = false;
  const bool right = now_->law().evaluate(tick);
  if (right) begin_ramp();
  failed.release();
  return right;
}

bool LawChange::too_far() RT_SAFE {
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    if (kinds_[i] != Limit::force && kinds_[i] != Limit::moment) continue;
    const double limit = kinds_[i] == Limit::force ? limits_.force : limits_.moment;
    const double step = std::abs(now_->law().found(i) - last_[i]);
    if (step <= limit) continue;
    tell(Event::Kind::reload_undone, "its force differs too much", step, limit);
    return true;
  }
  return false;
}

/// From where the outputs are to where the law in charge has them.
void LawChange::begin_ramp() RT_SAFE {
  ramp_.begin(limits_.ramp_steps);
  for (std::size_t i = 0; i < kinds_.size(); ++i)
    ramp_.at(i) = kinds_[i] == Limit::none ? 0.0 : last_[i] - now_->law().found(i);
}

void LawChange::keep_outputs() RT_SAFE {
  for (std::size_t i = 0; i < last_.size(); ++i) last_[i] = now_->law().found(i) + ramp_.add(i);
}

void LawChange::end_probation() RT_SAFE {
  if (former_ == nullptr) return;
  former_->release();
  former_ = nullptr;
}

void LawChange::tell(Event::Kind kind, const char* detail, double value, double limit) RT_SAFE {
  if (untold_ == news_.size()) return;
  news_[untold_++] = {.kind = kind, .detail = detail, .value = value, .limit = limit};
}

bool LawChange::take_news(Event& news) RT_SAFE {
  if (untold_ == 0) return false;
  news = news_[0];
  std::shift_left(news_.begin(), news_.end(), 1);
  --untold_;
  return true;
}

}  // namespace trocar::lua
