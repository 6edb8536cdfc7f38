// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "components/kinematics/laparoscope_limit_parameters.hpp"
#include "components/kinematics/laparoscope_parameters.hpp"
#include "components/kinematics/workspace.hpp"

namespace trocar::cli {

/// What `trocar workspace` can be told of the device and of how to sample it, each with the name
/// that scripts use.
class WorkspaceOptions {
 public:
  void add_to(CLI::App& command);

  WorkspaceSettings settings() const;
  unsigned threads() const { return static_cast<unsigned>(*machine_.threads); }
  bool with_weight() const { return weight_; }

  /// Each parameter that the result depends on.
  std::vector<ParameterBase*> parameters() const;

  /// An error of the library, which speaks of its members, with the names of the options.
  static std::string explain(std::string error);

 private:
  struct Geometry final : ParameterSet {
    LaparoscopeGeometryParameters all{this};
  };
  struct Limits final : ParameterSet {
    LaparoscopeLimitParameters all{this};
  };
  struct Efforts final : ParameterSet {
    Parameter<double> slider_peak = force("slider_peak", "200 N", "of a slider");
    Parameter<double> slider_continuous = force("slider_continuous", "60 N", "of a slider");
    Parameter<double> ring_peak = moment("ring_peak", "12 N m", "of a ring");
    Parameter<double> ring_continuous = moment("ring_continuous", "2.7 N m", "of a ring");

   private:
    Parameter<double> force(const char* name, const char* initial, const char* doc) {
      return {this,
              name,
              {.unit = "N", .initial = initial, .min = "0 N", .max = "10000 N", .doc = doc}};
    }
    Parameter<double> moment(const char* name, const char* initial, const char* doc) {
      return {this,
              name,
              {.unit = "N m", .initial = initial, .min = "0 N m", .max = "1000 N m", .doc = doc}};
    }
  };
  struct Weight final : ParameterSet {
    MountParameter mount{this};
    LaparoscopeMassParameters masses{this};
  };
  struct Sampling final : ParameterSet {
    Parameter<std::int64_t> seed{
        this, "seed", {.initial = "1", .min = "0", .doc = "of the random shifts"}};
    Parameter<std::int64_t> shifts{
        this,
        "shifts",
        {.initial = "16", .min = "2", .max = "1024", .doc = "whose spread is the standard error"}};
    Parameter<std::int64_t> tips = points("tips", "8192", "under each shift, a power of 2");
    Parameter<std::int64_t> poses = points("poses", "65536", "under each shift, a power of 2");
    Parameter<double> cell{this,
                           "cell",
                           {.unit = "m",
                            .initial = "20 mm",
                            .min = "1 mm",
                            .max = "1000 mm",
                            .doc = "edge of the map's cells"}};

   private:
    Parameter<std::int64_t> points(const char* name, const char* initial, const char* doc) {
      return {this, name, {.initial = initial, .min = "256", .doc = doc}};
    }
  };
  struct Machine final : ParameterSet {
    Parameter<std::int64_t> threads{
        this,
        "threads",
        {.initial = "0", .min = "0", .max = "1024", .doc = "0: one for each processor"}};
  };

  Geometry geometry_;
  Limits limits_;
  Efforts efforts_;
  Weight masses_;
  Sampling sampling_;
  Machine machine_;
  bool weight_ = false;
};

}  // namespace trocar::cli
