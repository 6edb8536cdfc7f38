// SPDX-License-Identifier: Apache-2.0
#include "cli/parameter_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/output.hpp"

namespace trocar::cli {
namespace {

constexpr std::size_t longest_default = 20;  // [characters] that a line of the help has room for

std::string doc_of(const ParameterBase& parameter) {
  const std::string initial = parameter.text();
  if (initial.size() > longest_default || !parameter.choices().empty()) return parameter.doc();
  const std::string range = parameter.range_text();
  return fmt::format("{} ({}default {})", parameter.doc(), range.empty() ? "" : range + ", ",
                     initial);
}

}  // namespace

std::string option_name(std::string_view parameter) {
  std::string name = "--" + std::string(parameter);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

void add_parameter_options(CLI::App& command, ParameterSet& set, const std::string& group) {
  for (ParameterBase* parameter : set.parameters()) {
    const std::string name = option_name(parameter->name());
    const auto take = [parameter, name](const std::string& text) {
      const std::string wrong = parameter->set(literal_from_text(text));
      if (!wrong.empty()) throw CLI::ValidationError(name, in_quotes(text) + ": " + wrong);
    };
    CLI::Option* option = command.add_option_function<std::string>(name, take, doc_of(*parameter));
    option->group(group)->type_name("VALUE");
    if (!parameter->choices().empty()) option->check(CLI::IsMember(parameter->choices()));
  }
}

}  // namespace trocar::cli
