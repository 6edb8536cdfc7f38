// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// @file
/// Reading of a graph's description (docs/log-format.md#graphjson), which comes over a network or
/// out of a file: what is not as it should be is as if it were not there.

namespace trocar::gui {

struct Sources;

using GraphJson = nlohmann::json;

/// Of the run that is looked at, live or from a log; null where it is not known.
const GraphJson& graph_of(const Sources& sources);

/// "" where there is no such text.
std::string graph_text(const GraphJson& object, const char* key);
bool graph_flag(const GraphJson& object, const char* key);
/// An empty list where there is none.
const GraphJson& graph_list(const GraphJson& object, const char* key);
/// The entry of that name in a list; null where there is none.
const GraphJson& graph_entry(const GraphJson& object, const char* list, const std::string& name);
/// A parameter's numbers in SI; none where it has none.
std::vector<double> graph_numbers(const GraphJson& node, const char* parameter);
/// "laparoscope.tool.tip.position", which the input reads, or "".
std::string graph_source(const GraphJson& graph, const std::string& node, const std::string& input);

}  // namespace trocar::gui
