// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "framework/registry.hpp"
#include "framework/scripting/law_change.hpp"
#include "framework/scripting/law_history.hpp"
#include "framework/scripting/law_ports.hpp"
#include "framework/scripting/lua_law.hpp"

namespace trocar::lua {

/// A component whose ports, parameters and step a file in Lua defines; a LuaFixture when the file
/// says trocar.fixture, and a LuaComponent when it says trocar.component.
///
/// The step runs under a guard. When it fails or is late, none of its outputs is written, the fault
/// with file and line latches, and a force that it renders at a site may only resist from then on;
/// nobody else's tick is touched.
class LuaComponent final : public Component, public Replaceable {
 public:
  explicit LuaComponent(std::shared_ptr<const LawFile> file);

  /// @throw std::invalid_argument when the file does not load with these limits
  void configure(const Setup& setup) override;
  void start() override;
  /// Not RT_SAFE in the strict sense: what it calls is the researcher's. It is bounded by the
  /// guard, and allocates from the law's pool alone.
  void step(const Tick& tick) RT_SAFE override;
  bool wants_slack() const override { return true; }
  void use_slack() RT_SAFE override;
  bool wants_duration() const override { return true; }
  void take_duration(std::int64_t ns) RT_SAFE override { *time_ = static_cast<double>(ns) * 1e-9; }

  const std::string& source() const override { return file_->path; }
  std::unique_ptr<Replacement> prepare(const Reload& reload) override;
  void replace(Replacement& next) RT_SAFE override;
  bool take_news(Event& news) RT_SAFE override { return change_.take_news(news); }

 private:
  LoopLimits limits() const;
  LawMemory ports();
  void begin_history();
  void remember(const Tick& tick) RT_SAFE;
  // Of another version that is made ready:
  std::vector<ParameterBase*> same_parameters(const LuaComponent& next) const;
  void copy_settings(const LuaComponent& other);
  void recall(const LawHistory::Step& step, const std::vector<ParameterBase*>& before);
  void try_on(const std::vector<LawHistory::Step>& steps, const LuaComponent& other);

  std::shared_ptr<const LawFile> file_;
  std::deque<AnyInput> inputs_;
  std::deque<AnyOutput> outputs_;
  DeclaredParameters declared_;
  std::vector<ParameterBase*> of_the_file_;

  Parameter<std::int64_t> memory_{
      this,
      "memory",
      {.initial = "512", .min = "96", .max = "65536", .doc = "KiB that the script may hold"}};
  Parameter<std::int64_t> instructions_{
      this,
      "instructions",
      {.initial = "10000", .min = "100", .max = "1e9", .doc = "of Lua's that one step may take"}};
  Parameter<double> deadline_{this,
                              "deadline",
                              {.unit = "s",
                               .initial = "0 us",
                               .min = "0 us",
                               .max = "1e6 us",
                               .doc = "that one step may take in real time; 0: a fifth of its "
                                      "period"}};
  Parameter<bool> strict_{
      this, "strict", {.initial = "false", .doc = "a step that allocates memory is an error"}};

  Parameter<double> reload_limit_{this,
                                  "reload_limit",
                                  {.unit = "N",
                                   .initial = "2 N",
                                   .min = "0 N",
                                   .max = "100 N",
                                   .doc = "that a reload may change a force by; it is ramped"}};

  Output<double> time_{this, "script.time", {.unit = "s", .doc = "of its step; 0 in virtual time"}};
  Output<std::int64_t> allocations_{
      this, "script.allocations", {.doc = "of its last step, from the script's own memory"}};
  Output<std::int64_t> held_{this, "script.memory", {.doc = "bytes that the script holds"}};

  Setup setup_;
  std::unique_ptr<LawVersion> first_;
  LawChange change_;
  std::optional<LawHistory> history_;
  LawState::Numbers remembered_state_{};
  std::vector<std::string> state_names_;  // of all versions; not the loop's
};

/// The type of the components that a file makes.
std::unique_ptr<ComponentType> law_type(std::shared_ptr<const LawFile> file);

}  // namespace trocar::lua
