// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/law_shim.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace trocar::lua {
namespace {

constexpr std::size_t most_inputs = 150;  // Lua's limit is 200 local variables in a function
constexpr std::size_t most_outputs = 80;
constexpr std::size_t most_tables = 80;

/// Writes what one side, inputs or outputs, is made of.
class Side {
 public:
  Side(LawShim& shim, std::vector<LawNumber>& numbers, const char* name, std::size_t& tables)
      : shim_(shim), numbers_(numbers), name_(name), tables_(tables) {}

  void add(const std::vector<LawPort>& ports) {
    for (std::size_t i = 0; i < ports.size(); ++i) {
      port_ = i;
      const LawPort& port = ports[i];
      fields_ += fmt::format("{} = {}, ", port.name, value(port));
      known_ += fmt::format("{} = true, ", port.name);
    }
  }

  std::string tables_text;  // makes the tables
  std::string arguments;    // ", a1, a2"
  std::string fill;         // a number's way in
  std::string reset;        // to where an output begins in each tick
  std::string take;         // what a law put in the place of a table
  std::string results;      // a number's way out
  const std::string& fields() const { return fields_; }
  const std::string& known() const { return known_; }

 private:
  bool out() const { return std::string_view(name_) == "out"; }

  /// The expression that a port's field is at first.
  std::string value(const LawPort& port) {
    const std::string place = fmt::format("{}.{}", out() ? "out" : "inputs", port.name);
    if (port.type->fields.empty()) return leaf(port, place);
    const std::string table = composite(*port.type, port.axes_of(), port.name, 0);
    if (out())
      take += fmt::format("  if {0} ~= {1} then take({1}, {0}, \"{2}\") {0} = {1} end\n", place,
                          table, port.name);
    return table;
  }

  std::string leaf(const LawPort& port, const std::string& place) {
    using Kind = LawNumber::Kind;
    const TypeInfo* type = port.type;
    const std::string shown = fmt::format("{}.{}", name_, port.name);
    if (type == &type_info<Enumeration>()) {
      shim_.labels.push_back(port.labels);
      const std::size_t list = shim_.labels.size();
      number(Kind::label, 0, shown, place, fmt::format("labels{}[{{}}]", list),
             fmt::format("labels{}[{{}}]", list), fmt::format("labels{}[1]", list));
      return fmt::format("labels{}[1]", list);
    }
    const Kind kind = type->scalar == Scalar::boolean
                          ? Kind::boolean
                          : (type->scalar == Scalar::integer ? Kind::integer : Kind::real);
    const char* first = kind == Kind::boolean ? "false" : (kind == Kind::integer ? "0" : "0.0");
    number(kind, 0, shown, place, "{}", "{}", first);
    return first;
  }

  /// Makes a table and returns its name; a vector has methods, other tables only their fields.
  std::string composite(const TypeInfo& type, int axes, const std::string& shown,
                        std::size_t offset) {
    const std::string table = fmt::format("t{}", ++tables_);
    const bool vector = &type == &type_info<Vector3>();
    std::string fields;
    if (type.per_axis == 6) {
      for (int row = 0; row < 6; ++row) {
        const std::string line = fmt::format("t{}", ++tables_);
        std::string numbers;
        for (int column = 0; column < axes; ++column) {
          const auto at = static_cast<std::size_t>(column * 6 + row);
          real(offset + 8 * at, fmt::format("{}.{}[{}][{}]", name_, shown, row + 1, column + 1),
               fmt::format("{}[{}]", line, column + 1), false);
          numbers += "0.0, ";
        }
        tables_text += fmt::format("local {} = record({{ {} }}, \"{}.{}[{}]\")\n", line, numbers,
                                   name_, shown, row + 1);
        fields += line + ", ";
      }
    }
    const std::size_t count = type.per_axis == 6 ? 0 : field_count(type, axes);
    for (std::size_t i = 0; i < count; ++i) {
      const TypeField& field = type.fields[i];
      const std::string key =
          type.per_axis == 1 ? fmt::format("[{}]", i + 1) : fmt::format(".{}", field.name);
      const std::string first_key = type.per_axis == 1 ? "" : field.name + " = ";
      if (!field.type->fields.empty()) {
        const std::string inner = composite(*field.type, 0, shown + key, offset + field.offset);
        if (out())
          take +=
              fmt::format("  if {0}{1} ~= {2} then take({2}, {0}{1}, \"{3}\") {0}{1} = {2} end\n",
                          table, key, inner, shown + key);
        fields += fmt::format("{}{}, ", first_key, inner);
        continue;
      }
      const bool settled = &type == &type_info<Rotation>() && field.name == "w";
      real(offset + field.offset, fmt::format("{}.{}{}", name_, shown, key),
           fmt::format("{}{}", table, key), settled);
      fields += fmt::format("{}{}, ", first_key, settled ? "1.0" : "0.0");
    }
    tables_text += vector ? fmt::format("local {} = world.vector({})\n", table, !out())
                          : fmt::format("local {} = record({{ {} }}, \"{}.{}\")\n", table, fields,
                                        name_, shown);
    return table;
  }

  void real(std::size_t offset, const std::string& shown, const std::string& place, bool settled) {
    number(LawNumber::Kind::real, offset, shown, place, "{}", "{}", settled ? "1.0" : "0.0");
  }

  /// @param in, back how the number becomes the field's value, and that the number
  void number(LawNumber::Kind kind, std::size_t offset, const std::string& shown,
              const std::string& place, const std::string& in, const std::string& back,
              const std::string& first) {
    numbers_.push_back({kind, port_, offset, shown});
    const std::string argument = fmt::format("a{}", numbers_.size());
    if (out()) {
      reset += fmt::format("  {} = {}\n", place, first);
      results += (results.empty() ? "" : ", ") + fmt::format(fmt::runtime(back), place);
    } else {
      arguments += (arguments.empty() ? "" : ", ") + argument;
      fill += fmt::format("  {} = {}\n", place, fmt::format(fmt::runtime(in), argument));
    }
  }

  LawShim& shim_;
  std::vector<LawNumber>& numbers_;
  const char* name_;
  std::size_t& tables_;
  std::size_t port_ = 0;
  std::string fields_;
  std::string known_;
};

constexpr const char* frame = R"lua(
local definition, values, world{label_names} = ...
local step, take, setmetatable = definition.step, world.take, world.setmetatable
local function guard(t, owner, known, cure)
  return setmetatable(t, {{
    __index = world.no_such(owner, known),
    __newindex = world.no_assign(owner, cure, known),
  }})
end
local function record(t, name) return guard(t, name, t, "it has its fields and no others") end
local function read_only(fields, owner, cure)
  guard(fields, owner, fields, cure)
  return setmetatable({{}}, {{ __index = fields, __newindex = world.no_assign(owner, cure, fields) }})
end
{tables}
local inputs = {{ {input_fields} }}
local at = read_only(inputs, "{at}", "an input is read: a local keeps what is computed from it")
local p = read_only(values, "p", "a parameter is read: --set, set or an edit changes it")
local out = {{ {output_fields} }}
guard(out, "out", {{ {output_names} }}, "declare it in outputs, e.g. outputs = {{ depth = \"m\" }}")
local state = definition.state or {{}}
local kept = {{}}
for name in world.next, state do kept[name] = true end
guard(state, "state", kept, "declare it with what it is at first, state = {{ torn = false }}")
local tick = {{ time = 0.0, dt = 0.0 }}
return function({arguments})
{fill}{reset}{tick}  step(p, at, out, state{tick_argument})
{take}  return {results}
end, state
)lua";

}  // namespace

LawShim::LawShim(const LawFile& file, int step_parameters) {
  wants_tick = step_parameters >= 5;
  std::size_t tables = 0;
  const char* at = file.kind == LawKind::fixture ? "at" : "inputs";
  Side in(*this, inputs, at, tables);
  if (wants_tick) in.arguments = "time, dt";
  in.add(file.inputs);
  Side out(*this, outputs, "out", tables);
  out.add(file.outputs);
  if (inputs.size() > most_inputs || outputs.size() > most_outputs || tables > most_tables)
    throw std::invalid_argument(
        fmt::format("has {} numbers of inputs and {} of outputs in {} vectors and the like: {}, {} "
                    "and {} are possible",
                    inputs.size(), outputs.size(), tables, most_inputs, most_outputs, most_tables));
  std::string label_names;
  for (std::size_t i = 1; i <= labels.size(); ++i) label_names += fmt::format(", labels{}", i);
  text = fmt::format(fmt::runtime(frame), fmt::arg("label_names", label_names),
                     fmt::arg("tables", in.tables_text + out.tables_text),
                     fmt::arg("input_fields", in.fields()), fmt::arg("at", at),
                     fmt::arg("output_fields", out.fields()), fmt::arg("output_names", out.known()),
                     fmt::arg("arguments", in.arguments), fmt::arg("fill", in.fill),
                     fmt::arg("reset", out.reset),
                     fmt::arg("tick", wants_tick ? "  tick.time = time tick.dt = dt\n" : ""),
                     fmt::arg("tick_argument", wants_tick ? ", tick" : ""),
                     fmt::arg("take", out.take), fmt::arg("results", out.results));
}

}  // namespace trocar::lua
