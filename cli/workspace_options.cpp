// SPDX-License-Identifier: Apache-2.0
#include "cli/workspace_options.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "cli/parameter_options.hpp"

namespace trocar::cli {
namespace {

using Renaming = std::pair<std::string_view, std::string_view>;

/// What the library calls a thing, and the parameter that sets it, where they differ.
constexpr std::array renamed = {
    Renaming{"slider_low", "slider_lowest"}, Renaming{"slider_high", "slider_highest"},
    Renaming{"centre_offset", "centre_travel"}, Renaming{"engagement_low", "engagement_lowest"},
    Renaming{"engagement_high", "engagement_highest"}};

std::string parameter_called(std::string_view member) {
  for (const auto& [theirs, ours] : renamed)
    if (member == theirs) return std::string(ours);
  return std::string(member);
}

}  // namespace

void WorkspaceOptions::add_to(CLI::App& command) {
  add_parameter_options(command, geometry_, "Geometry");
  add_parameter_options(command, limits_, "Limits");
  add_parameter_options(command, efforts_, "Efforts");
  command.add_flag("--weight", weight_, "Subtract what holds the weight from the efforts")
      ->group("Weight");
  add_parameter_options(command, masses_, "Weight");
  add_parameter_options(command, sampling_, "Sampling");
  add_parameter_options(command, machine_, "Sampling");
}

WorkspaceSettings WorkspaceOptions::settings() const {
  return {.geometry = geometry_.all.value(),
          .limits = limits_.all.value(),
          .efforts = {.slider_peak = *efforts_.slider_peak,
                      .slider_continuous = *efforts_.slider_continuous,
                      .ring_peak = *efforts_.ring_peak,
                      .ring_continuous = *efforts_.ring_continuous},
          .masses = masses_.masses.value(),
          .gravity = weight_ ? masses_.mount.gravity() : Eigen::Vector3d::Zero(),
          .seed = static_cast<std::uint64_t>(*sampling_.seed),
          .shifts = static_cast<std::size_t>(*sampling_.shifts),
          .tips = static_cast<std::size_t>(*sampling_.tips),
          .poses = static_cast<std::size_t>(*sampling_.poses),
          .cell = *sampling_.cell};
}

std::vector<ParameterBase*> WorkspaceOptions::parameters() const {
  std::vector<const ParameterSet*> sets = {&geometry_, &limits_, &efforts_};
  if (weight_) sets.push_back(&masses_);
  sets.push_back(&sampling_);
  std::vector<ParameterBase*> all;
  for (const ParameterSet* set : sets)
    all.insert(all.end(), set->parameters().begin(), set->parameters().end());
  return all;
}

std::string WorkspaceOptions::explain(std::string error) {
  // "limits: slider_low = -0.1: must be …" is about the option --slider-lowest, in SI.
  const std::size_t colon = error.find(": "), equals = error.find(" = ");
  if (colon == std::string::npos || equals == std::string::npos || equals < colon) return error;
  const std::string member = error.substr(colon + 2, equals - colon - 2);
  return option_name(parameter_called(member)) + error.substr(equals);
}

}  // namespace trocar::cli
