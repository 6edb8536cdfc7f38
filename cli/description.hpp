// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "framework/registry.hpp"

namespace trocar::cli {

/// Everything that a component type declares, as texts.
struct Description {
  struct Port {
    std::string name{};
    std::string type{};  // "Vector3"; "any" where the wiring decides
    std::string unit{};  // one for each block: "N, N m"
    std::string frame{};
    std::string doc{};
    std::vector<std::string> labels{};  // of an enumeration
    bool optional = false;
    bool several = false;    // an input that takes more than one source
    bool truth = false;      // only a simulation can know it
    bool from_site = false;  // wired by `at`
  };
  struct Parameter {
    std::string name{};
    std::string type{};
    std::string unit{};
    std::string range{};
    std::string initial{};  // "" where a value is required
    std::string doc{};
    std::vector<std::string> choices{};
    bool live = false;
  };
  std::string name{};
  std::string category{};
  std::string doc{};
  bool group = false;
  bool placed = false;       // takes `at = site`
  std::string definition{};  // the entry that further outputs follow from
  std::string sample{};      // of it
  std::vector<Port> inputs{};
  std::vector<Port> outputs{};
  std::vector<Parameter> parameters{};
  std::vector<std::string> sites{};            // of a group
  std::map<std::string, std::string> parts{};  // of a group: name and type
  std::string example{};                       // one line of Lua
};

/// @throw std::invalid_argument when no type is called so, with the nearest that is.
Description describe(const Registry& registry, std::string_view name);

std::string description_text(const Description& description);
nlohmann::ordered_json description_json(const Description& description);

}  // namespace trocar::cli
