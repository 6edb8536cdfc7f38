// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/run_options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "framework/text.hpp"

namespace trocar::lua {

double quantity(const Literal& literal, const char* unit, const std::string& what) {
  const auto* number = literal.as<double>();
  if (number != nullptr && *number == 0.0) return 0.0;
  if (const auto* text = literal.as<std::string>()) {
    try {
      const Quantity read = parse_quantity(*text);
      if (read.unit.dimension == parse_unit(unit).dimension) return read.value;
    } catch (const UnitError& error) {
      throw std::invalid_argument(fmt::format("{} = {}", what, error.what()));
    }
  }
  throw std::invalid_argument(
      fmt::format("{} = {}: needs {}, e.g. \"1 {}\"", what, literal.text(), unit, unit));
}

namespace {

const Literal::Table& table_of(const Literal& literal, const std::string& what) {
  static const Literal::Table empty;
  if (const auto* table = literal.as<Literal::Table>()) return *table;
  if (const auto* list = literal.as<Literal::List>(); list != nullptr && list->empty())
    return empty;
  throw std::invalid_argument(
      fmt::format("{} = {}: needs a table, e.g. {{ [\"wall.stiffness\"] = \"3 N/mm\" }}", what,
                  literal.text()));
}

double within(double value, double min, double max, const char* range, const std::string& what) {
  if (value >= min && value <= max) return value;
  throw std::invalid_argument(fmt::format("{} = {:g}: {} is possible", what, value, range));
}

void read_edits(const Literal& literal, const Where& at, RunOptions& options) {
  const auto* list = literal.as<Literal::List>();
  if (list == nullptr)
    throw std::invalid_argument(
        "edits: needs a list, e.g. { { at = \"1 s\", [\"wall.stiffness\"] = \"3 N/mm\" } }");
  for (const Literal& one : *list) {
    double time = std::nan("");
    for (const auto& [key, value] : table_of(one, "edits"))
      if (key == "at") time = quantity(value, "s", "edits.at");
    if (!(time >= 0.0 && time < 1e7))
      throw std::invalid_argument("edits: each needs at = \"1 s\" or the like");
    for (const auto& [key, value] : table_of(one, "edits"))
      if (key != "at") options.edits.push_back({time, key, value, at});
  }
}

void read_reloads(const Literal& literal, RunOptions& options) {
  const auto* list = literal.as<Literal::List>();
  if (list == nullptr)
    throw std::invalid_argument(
        "reloads: needs a list, e.g. { { at = \"1 s\", membrane = \"membrane_2.lua\" } }");
  for (const Literal& one : *list) {
    double time = std::nan("");
    for (const auto& [key, value] : table_of(one, "reloads"))
      if (key == "at") time = quantity(value, "s", "reloads.at");
    if (!(time >= 0.0 && time < 1e7))
      throw std::invalid_argument("reloads: each needs at = \"1 s\" or the like");
    for (const auto& [key, value] : table_of(one, "reloads")) {
      if (key == "at") continue;
      const auto* file = value.as<std::string>();
      if (file == nullptr)
        throw std::invalid_argument(
            fmt::format("reloads.{} = {}: needs a file beside the script", key, value.text()));
      options.reloads.push_back({.at = time, .component = key, .file = *file});
    }
  }
}

Command::Kind request_kind(const Literal& literal) {
  const auto* text = literal.as<std::string>();
  if (const auto kind = text == nullptr ? std::nullopt : request_named(*text)) return *kind;
  throw std::invalid_argument(
      fmt::format("requests.ask = {}: stop, acknowledge, home, engage and end are{}",
                  literal.text(), text == nullptr ? "" : suggestion(*text, request_names())));
}

void read_requests(const Literal& literal, RunOptions& options) {
  const auto* list = literal.as<Literal::List>();
  if (list == nullptr)
    throw std::invalid_argument(
        "requests: needs a list, e.g. { { at = \"1 s\", ask = \"stop\" } }");
  for (const Literal& one : *list) {
    OperatorRequest request{.at = std::nan("")};
    std::optional<Command::Kind> kind;
    for (const auto& [key, value] : table_of(one, "requests")) {
      if (key == "at")
        request.at = quantity(value, "s", "requests.at");
      else if (key == "ask")
        kind = request_kind(value);
      else
        throw std::invalid_argument(
            fmt::format("requests: has no \"{}\"{}", key, suggestion(key, {"at", "ask"})));
    }
    if (!(request.at >= 0.0 && request.at < 1e7) || !kind)
      throw std::invalid_argument(
          "requests: each needs at = \"1 s\" and ask = \"stop\" or the like");
    request.kind = *kind;
    options.requests.push_back(request);
  }
}

}  // namespace

RunOptions default_run_options() {
  RunOptions options{.keep_rows = true};
  options.duration = 1.0;
  return options;
}

std::vector<std::string> run_option_names() {
  return {"rate", "duration", "seed", "set", "edits", "requests", "reloads", "keep"};
}

RunOptions read_run_options(const Literal& literal, const Where& at, RunOptions options) {
  for (const auto& [key, value] : table_of(literal, "trocar.run")) {
    if (key == "rate") {
      options.wiring.rate = within(quantity(value, "Hz", key), 1.0, 1e5, "1 Hz to 100 kHz", key);
    } else if (key == "duration") {
      options.duration = within(quantity(value, "s", key), 1e-5, 1e7, "10 µs to 1e7 s", key);
    } else if (key == "seed") {
      const auto* seed = value.as<double>();
      if (seed == nullptr || !(*seed >= 0.0 && *seed < 0x1p53) || std::floor(*seed) != *seed)
        throw std::invalid_argument(fmt::format("seed = {}: needs a whole number", value.text()));
      options.wiring.seed = static_cast<std::uint64_t>(*seed);
    } else if (key == "set") {
      for (const auto& [name, setting] : table_of(value, key))
        options.wiring.set.insert_or_assign(name, Graph::Override{setting, at});
    } else if (key == "edits") {
      read_edits(value, at, options);
    } else if (key == "reloads") {
      read_reloads(value, options);
    } else if (key == "keep") {
      continue;  // outputs are no literals: trocar.run reads them itself
    } else if (key == "requests") {
      read_requests(value, options);
    } else {
      throw std::invalid_argument(
          fmt::format("trocar.run has no \"{}\"{}", key, suggestion(key, run_option_names())));
    }
  }
  return options;
}

}  // namespace trocar::lua
