// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "framework/parameter.hpp"

namespace trocar {

/// Whatever has declared parameters: a component or a group.
class ParameterSet {
 public:
  ParameterSet() = default;
  ParameterSet(const ParameterSet&) = delete;
  ParameterSet& operator=(const ParameterSet&) = delete;
  virtual ~ParameterSet() = default;

  const std::vector<ParameterBase*>& parameters() const { return parameters_; }
  ParameterBase* find_parameter(std::string_view name) const;
  std::vector<std::string> parameter_names() const;

  /// Called by a parameter as it is constructed.
  void add(ParameterBase* parameter) { parameters_.push_back(parameter); }

 private:
  std::vector<ParameterBase*> parameters_;
};

}  // namespace trocar
