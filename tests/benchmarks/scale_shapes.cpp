// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/scale_shapes.hpp"

#include <fmt/format.h>

namespace trocar::bench {
namespace {

std::string chain(int components) {
  return fmt::format(R"(
local last = trocar.Constant {{ name = "first", value = "1 N" }}
for i = 2, {} do
  last = trocar.Scale {{ name = "scale" .. i, input = last.value, factor = 0.5 }}
end
)",
                     components);
}

std::string side_by_side(int components) {
  return fmt::format(R"(
for i = 1, {} do
  trocar.Constant {{ name = "constant" .. i, value = "1 N" }}
end
)",
                     components);
}

std::string sums(int components) {
  return fmt::format(R"(
local total = trocar.Constant {{ value = "1 N" }}.value
local one = total
for i = 2, {} do
  total = total + one
end
)",
                     components);
}

std::string late(int components) {
  return fmt::format(R"(
local one = trocar.Constant {{ value = "1 N" }}.value
for i = 2, {} do
  one:delay {{ name = "delay" .. i, initial = "0 N" }}
end
)",
                     components);
}

std::string groups(int components) {
  return fmt::format(R"(
local Pair = trocar.group {{
  name = "Pair",
  parameters = {{ gain = {{ 0.5 }} }},
  build = function(parameters)
    local source = trocar.Constant {{ name = "source", value = "1 N" }}
    local scale = trocar.Scale {{ name = "scale", input = source.value, factor = parameters.gain }}
    return {{ value = scale.value }}
  end,
}}
for i = 1, {} do
  Pair {{ name = "pair" .. i, gain = 0.25 }}
end
)",
                     components / 2);
}

std::string walls(int components) {
  return fmt::format(R"(
local laparoscope = trocar.Laparoscope {{ hand = "push" }}
for i = 6, {} do
  trocar.Wall {{ name = "wall" .. i, at = laparoscope.tip, point = {{ 0, 0, "105 mm" }},
                 normal = {{ 0, 0, -1 }}, stiffness = "1 N/m" }}
end
)",
                     components);
}

std::string crossings(int components) {
  return fmt::format(R"(
local fast = trocar.thread {{ rate = "1 kHz" }}
local slow = trocar.thread {{ rate = "100 Hz" }}
for i = 1, {} do
  local source = slow.Constant {{ name = "source" .. i, value = "1 N" }}
  fast.Scale {{ name = "scale" .. i, input = source.value:latest(), factor = 0.5 }}
end
)",
                     components / 2);
}

}  // namespace

const std::vector<ScaleShape>& scale_shapes() {
  static const std::vector<ScaleShape> shapes = {
      {"chain", "one after the other", chain},
      {"side by side", "nothing is wired", side_by_side},
      {"sums", "a + b, without names", sums},
      {"late", "inputs that are read a tick later", late},
      {"groups", "of two, with a parameter that follows", groups},
      {"walls", "all at the tip of one laparoscope", walls},
      {"crossings", "every wire leads to another thread", crossings}};
  return shapes;
}

}  // namespace trocar::bench
