// SPDX-License-Identifier: Apache-2.0
#include "cli/script_options.hpp"

#include <fmt/format.h>

#include "cli/output.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

constexpr std::size_t most_digits = 15;  // what JSON's numbers hold, and CLI11 does not wrap round

}  // namespace

void ScriptOptions::add_to(CLI::App& command) {
  command.add_option("script", script, "The Lua script")->required()->type_name("FILE.lua");
  command
      .add_option(
          "--set", settings,
          "Override a parameter (wall.stiffness=\"3 N/mm\"), or set an entry of trocar.args "
          "(subject=7)")
      ->allow_extra_args(false);
  add_seed_option(command, seed);
}

void add_seed_option(CLI::App& command, std::optional<std::uint64_t>& seed) {
  command.add_option("--seed", seed, "Of everything random (default 1)")
      ->check([](const std::string& text) {
        const bool whole = !text.empty() && text.size() <= most_digits &&
                           text.find_first_not_of("0123456789") == std::string::npos;
        return whole ? "" : in_quotes(text) + " is no whole number of up to 15 digits";
      });
}

void ScriptOptions::split(Graph::Overrides& parameters, Graph::Overrides& arguments) const {
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    const std::string key(trim(setting.substr(0, equals)));
    if (equals == std::string::npos || key.empty())
      throw CLI::ValidationError(
          "--set", fmt::format("\"{}\" is no setting, e.g. wall.stiffness=\"3 N/mm\"", setting));
    auto& target = key.find('.') == std::string::npos ? arguments : parameters;
    target.insert_or_assign(
        key, Graph::Override{literal_from_text(setting.substr(equals + 1)), {"--set", 0}});
  }
}

std::string check_file_name(const std::string& text) {
  return text.empty() ? "needs a file name, not \"\"" : "";
}

std::string mistakes_text(const Findings& findings) {
  const std::size_t count = findings.all().size();
  return fmt::format("{} {}:\n{}", count, count == 1 ? "mistake" : "mistakes", findings.text());
}

double duration_of(const std::string& text, const std::string& option) {
  try {
    const Quantity quantity = parse_quantity(text);
    if (quantity.unit.dimension == parse_unit("s").dimension && quantity.value > 0.0 &&
        quantity.value < 1e7)
      return quantity.value;
  } catch (const UnitError&) {
  }
  throw CLI::ValidationError(
      option,
      fmt::format("\"{}\" is no duration, e.g. 5s, 200ms or 2min (more than 0, less than 1e7 s)",
                  text));
}

}  // namespace trocar::cli
